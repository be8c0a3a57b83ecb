package brickless.files;

/** A file or a folder. */
abstract class Entry {
    /** When it was changed last, in milliseconds of the program's clock. */
    long modifiedMillis;

    Entry(long modifiedMillis) {
        this.modifiedMillis = modifiedMillis;
    }
}
