package brickless.loading;

/**
 * A class after rewriting.
 *
 * @param bytes its class file; not to be changed
 * @param statics the class file of the class that holds the statics of an interface; null if there is none
 */
record RewrittenClass(byte[] bytes, byte[] statics) {
    /** Bytes in memory. */
    int size() {
        return bytes.length + (statics == null ? 0 : statics.length);
    }
}
