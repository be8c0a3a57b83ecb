/** Programs that never end, of the kinds whose speed is measured. */
package programs.speed;
