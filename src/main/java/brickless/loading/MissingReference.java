package brickless.loading;

/**
 * A use of a leJOS class or member that does not exist here.
 *
 * @param owner binary name of the leJOS class
 * @param member name and descriptor of the missing method or field, empty if the whole class is missing
 * @param usedBy binary name of the program's class
 * @param line its line, 0 if unknown
 */
public record MissingReference(String owner, String member, String usedBy, int line)
        implements Comparable<MissingReference> {
    /** Such as {@code lejos.hardware.Sound.sing(I)V used by Singer:12}. */
    @Override
    public String toString() {
        return owner + (member.isEmpty() ? "" : "." + member) + " used by " + usedBy + (line == 0 ? "" : ":" + line);
    }

    @Override
    public int compareTo(MissingReference other) {
        return toString().compareTo(other.toString());
    }
}
