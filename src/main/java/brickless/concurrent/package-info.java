/**
 * Blocking classes of {@code java.util.concurrent} for programs in virtual time, under the same simple names; the
 * loader maps the JDK's names in programs to these. They are loaded per robot and rewritten like program code, so
 * everything they do is virtual; in an ordinary JVM they are ordinary, working Java.
 *
 * <p><b>The rule: a JDK class is replaced only if it can block, or holds a lock of its own while it calls back into
 * program code.</b> Interfaces, exceptions, enums, atomics and the concurrent collections that do neither stay the
 * JDK's. {@code RejectedExecutionHandler} has a counterpart here because its signature names a replaced class.
 * {@code CompletableFuture} and {@code ConcurrentHashMap} extend the JDK's and replace only what blocks, makes threads
 * or calls back under a lock; every other class here stands everywhere in place of the JDK's.
 *
 * <p>Not replaced, although they block or call back under a lock: parallel streams (they run on the host's threads;
 * programs should not use them), {@code CountedCompleter}, {@code SubmissionPublisher}, {@code
 * AbstractQueuedSynchronizer} and its kin, and copy-on-write lists while {@code removeIf}, {@code replaceAll} or
 * {@code sort} call a function of the program.
 *
 * <p>What the classes are made of: {@code synchronized}, {@code wait}, {@code notifyAll}, {@code Thread}, {@code
 * Thread.sleep}, {@code System.nanoTime} and JDK collections that do not block. The brick has one processor, so every
 * default parallelism is 1. Unlike the originals, locks, queues and synchronizers are not serializable.
 *
 * <p>Contracts are those of the public Java 17 documentation. May use: {@code brickless.concurrent.locks}, the JDK.
 */
package brickless.concurrent;
