/** Whole programs as students write them, in many styles. Each may use lejos and the JDK only. */
package programs.students;
