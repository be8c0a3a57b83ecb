package brickless.loading;

/**
 * The bytes of a class and where they came from, for messages.
 *
 * @param bytes class file; not to be changed
 * @param origin directory, jar or loader
 */
record ClassFile(byte[] bytes, String origin) {}
