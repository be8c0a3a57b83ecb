package brickless.concurrent;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Every member that a program can use in the JDK's class exists in the replacement, with types replaced alike. */
class SignatureTest {
    /** The ring buffer that the original lets subclasses see; nobody is known to use it. */
    private static final Set<String> LEFT_OUT = Set.of("[B buffer", "int in", "int out");
    /** What newer JDKs added to classes; what they added to interfaces comes with defaults. */
    private static final Pattern NEWER_THAN_17 =
            Pattern.compile("ThreadPerTaskExecutor|externalSubmit|lazySubmit|submitWithTimeout"
            + "|ScheduledFuture schedule[^ ]*\\[.*TimeUnit\\]|setParallelism|Uninterruptibly\\[|DelayedTask"
            + "|quietlyJoin\\[long"
            + "|adaptInterruptible|<init>\\[java.lang.ThreadGroup, ForkJoinPool|int getQueuedTaskCount\\[\\]");

    @ParameterizedTest
    @ValueSource(strings = {"ReentrantLock", "ReentrantReadWriteLock", "ReentrantReadWriteLock$ReadLock",
        "ReentrantReadWriteLock$WriteLock", "StampedLock"})
    void locksHaveAllMembers(String name) throws ClassNotFoundException {
        assertComplete("java.util.concurrent.locks." + name, "brickless.concurrent.locks." + name);
    }

    @ParameterizedTest
    @ValueSource(strings = {"CountDownLatch", "Semaphore", "CyclicBarrier", "Exchanger", "Phaser",
        "ArrayBlockingQueue", "LinkedBlockingQueue", "LinkedBlockingDeque", "PriorityBlockingQueue", "DelayQueue",
        "SynchronousQueue", "LinkedTransferQueue", "FutureTask", "AbstractExecutorService", "ThreadPoolExecutor",
        "ThreadPoolExecutor$AbortPolicy", "ThreadPoolExecutor$CallerRunsPolicy", "ThreadPoolExecutor$DiscardPolicy",
        "ThreadPoolExecutor$DiscardOldestPolicy", "RejectedExecutionHandler", "ScheduledThreadPoolExecutor",
        "ExecutorCompletionService", "Executors", "CompletableFuture", "ForkJoinPool",
        "ForkJoinPool$ForkJoinWorkerThreadFactory", "ForkJoinPool$ManagedBlocker", "ForkJoinTask",
        "ForkJoinWorkerThread", "RecursiveTask", "RecursiveAction", "ConcurrentHashMap"})
    void synchronizersQueuesAndExecutorsHaveAllMembers(String name) throws ClassNotFoundException {
        assertComplete("java.util.concurrent." + name, "brickless.concurrent." + name);
    }

    @ParameterizedTest
    @ValueSource(strings = {"Timer", "TimerTask", "Vector", "Stack", "Hashtable"})
    void collectionsAndTimersHaveAllMembers(String name) throws ClassNotFoundException {
        assertComplete("java.util." + name, "brickless.concurrent.util." + name);
    }

    @ParameterizedTest
    @ValueSource(strings = {"PipedInputStream", "PipedOutputStream", "PipedReader", "PipedWriter"})
    void pipesHaveAllMembers(String name) throws ClassNotFoundException {
        assertComplete("java.io." + name, "brickless.concurrent.io." + name);
    }

    @Test
    void printStreamsHaveAllConstructorsAndOverrideEveryMethod() throws ClassNotFoundException {
        assertComplete("java.io.PrintStream", "brickless.concurrent.io.ProgramPrintStream");
        Class<?> ours = Class.forName("brickless.concurrent.io.ProgramPrintStream");
        List<String> inherited = new ArrayList<>();
        for (Method method : java.io.PrintStream.class.getDeclaredMethods()) {
            boolean overridable = usable(method) && !method.isBridge() && !Modifier.isStatic(method.getModifiers());
            if (overridable && !method.getName().equals("charset")) {
                try {
                    ours.getDeclaredMethod(method.getName(), method.getParameterTypes());
                } catch (NoSuchMethodException e) {
                    inherited.add(method.toString());
                }
            }
        }
        assertThat(inherited).isEmpty();
    }

    @Test
    void completableFutureReplacesAllStaticMethodsWithTheSameDescriptors() throws NoSuchMethodException {
        for (Method original : java.util.concurrent.CompletableFuture.class.getDeclaredMethods()) {
            if (Modifier.isStatic(original.getModifiers()) && Modifier.isPublic(original.getModifiers())) {
                Method ours = CompletableFuture.class.getDeclaredMethod(original.getName(),
                        original.getParameterTypes());
                assertThat(ours.getReturnType()).as(ours.toString()).isEqualTo(original.getReturnType());
            }
        }
    }

    @Test
    void synchronizedWrappersHaveTheSignaturesOfCollections() throws NoSuchMethodException, ClassNotFoundException {
        Class<?> ours = Class.forName("brickless.concurrent.util.SynchronizedCollections");
        for (Method original : java.util.Collections.class.getMethods()) {
            if (original.getName().startsWith("synchronized")) {
                assertThat(ours.getMethod(original.getName(), original.getParameterTypes()).getReturnType())
                        .isEqualTo(original.getReturnType());
            }
        }
    }

    private static void assertComplete(String jdkName, String ourName) throws ClassNotFoundException {
        Set<String> missing = signatures(Class.forName(jdkName));
        missing.removeAll(signatures(Class.forName(ourName)));
        missing.removeAll(LEFT_OUT);
        if (Runtime.version().feature() > 17) {
            missing.removeIf(signature -> NEWER_THAN_17.matcher(signature).find());
        }
        assertThat(missing).as(ourName).isEmpty();
    }

    private static Set<String> signatures(Class<?> type) {
        Set<String> signatures = new TreeSet<>();
        for (Constructor<?> constructor : type.getDeclaredConstructors()) {
            if (usable(constructor)) {
                signatures.add("<init>" + parameters(constructor.getParameterTypes()));
            }
        }
        for (Class<?> c = type; c != null; c = c.getSuperclass()) {
            addDeclared(c, signatures);
        }
        for (Method method : type.getMethods()) {
            signatures.add(describe(method));
        }
        return signatures;
    }

    private static void addDeclared(Class<?> type, Set<String> signatures) {
        for (Method method : type.getDeclaredMethods()) {
            if (usable(method)) {
                signatures.add(describe(method));
            }
        }
        for (Field field : type.getDeclaredFields()) {
            if (usable(field)) {
                signatures.add((Modifier.isStatic(field.getModifiers()) ? "static " : "") + neutral(field.getType())
                        + " " + field.getName());
            }
        }
    }

    private static boolean usable(Member member) {
        return !member.isSynthetic()
                && (Modifier.isPublic(member.getModifiers()) || Modifier.isProtected(member.getModifiers()));
    }

    private static String describe(Method method) {
        return (Modifier.isStatic(method.getModifiers()) ? "static " : "") + neutral(method.getReturnType()) + " "
                + method.getName()
                + parameters(method.getParameterTypes());
    }

    private static String parameters(Class<?>[] types) {
        return Arrays.stream(types).map(SignatureTest::neutral).toList().toString();
    }

    /** The name of a type as it is after replacement. */
    private static String neutral(Class<?> type) {
        return type.getName().replace("java.util.concurrent.", "").replace("brickless.concurrent.util.", "java.util.")
                .replace("brickless.concurrent.io.", "java.io.").replace("brickless.concurrent.", "");
    }
}
