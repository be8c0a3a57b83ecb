package brickless.loading;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/**
 * Every construct that is rewritten, and every way to run away, has a program that uses it; {@link ProgramsTest} runs
 * them. One line each: what it is, the program below {@code programs}, and what its class files must contain.
 */
class RewritingTableTest {
    private static final String THREAD = "java/lang/Thread.";
    private static final String SYSTEM = "java/lang/System.";
    private static final String CONCURRENT = "java/util/concurrent/";

    private static final List<Row> TABLE = List.of(
            // charges
            row("jump back", "failing.runaways.EndlessLoop", "loop"),
            row("jump back out of a switch", "failing.runaways.SwitchInALoop", "switch"),
            row("loop that only reads", "failing.runaways.SpinsWithoutACall", "loop"),
            row("loop until another thread sets a field", "passing.threads.SpinUntilFlag", "loop"),
            row("lambda body", "passing.concurrency.SharedMap", "lambda"),
            row("array creation", "passing.limits.OutOfMemory", "array"),
            row("calls", "passing.limits.StackOverflow"),
            // monitors
            row("synchronized block", "passing.monitors.SynchronizedBlocks", "monitor"),
            row("synchronized method", "passing.monitors.SynchronizedMethods", "synchronized"),
            row("static synchronized method", "passing.monitors.SynchronizedMethods", "static synchronized"),
            row("wait", "passing.interrupts.InterruptWait", "call java/lang/Object.wait"),
            row("wait with a time-out", "passing.monitors.WaitWithTimeout", "call java/lang/Object.wait"),
            row("notify", "passing.monitors.NotifyWakesOne", "call java/lang/Object.notify"),
            row("notifyAll", "passing.monitors.NotifyWakesOne", "call java/lang/Object.notifyAll"),
            row("holdsLock", "passing.monitors.SynchronizedMethods", "call " + THREAD + "holdsLock"),
            // threads
            row("new Thread", "passing.threads.StartAndJoin", "new java/lang/Thread"),
            row("extends Thread", "passing.threads.SubclassOfThread", "extends java/lang/Thread"),
            row("start", "passing.threads.StartAndJoin", "call " + THREAD + "start"),
            row("join", "passing.threads.StartAndJoin", "call " + THREAD + "join"),
            row("join with a time-out", "passing.threads.JoinWithTimeout", "call " + THREAD + "join"),
            row("isAlive", "passing.threads.JoinWithTimeout", "call " + THREAD + "isAlive"),
            row("getState", "passing.threads.ThreadStates", "call " + THREAD + "getState"),
            row("sleep", "passing.threads.WaysToSleep", "call " + THREAD + "sleep"),
            row("TimeUnit.sleep", "passing.threads.WaysToSleep", "call " + CONCURRENT + "TimeUnit.sleep"),
            row("yield", "passing.threads.Priorities", "call " + THREAD + "yield"),
            row("currentThread", "passing.threads.NamesAndIds", "call " + THREAD + "currentThread"),
            row("ids", "passing.threads.NamesAndIds", "call " + THREAD + "getId"),
            row("interrupt while sleeping", "passing.interrupts.InterruptSleep", "call " + THREAD + "interrupt"),
            row("interrupt while joining", "passing.interrupts.InterruptJoin", "call " + THREAD + "interrupt"),
            row("interrupt while running", "passing.interrupts.InterruptRunning", "call " + THREAD + "interrupted"),
            row("isInterrupted", "passing.interrupts.InterruptRunning", "call " + THREAD + "isInterrupted"),
            row("daemon threads", "passing.threads.DaemonsDoNotKeepTheProgramAlive", "call " + THREAD + "setDaemon"),
            row("priorities", "passing.threads.Priorities", "call " + THREAD + "setPriority"),
            row("stop", "passing.threads.StopIsRefused", "call " + THREAD + "stop"),
            row("thread groups", "passing.threads.Groups", "call " + THREAD + "enumerate"),
            row("thread locals", "passing.threads.ThreadLocals", "extends java/lang/ThreadLocal",
                    "call java/lang/ThreadLocal.withInitial"),
            row("uncaught exception handlers", "passing.threads.UncaughtHandlers",
                    "call " + THREAD + "setDefaultUncaughtExceptionHandler",
                    "call " + THREAD + "setUncaughtExceptionHandler"),
            row("LockSupport", "passing.threads.ParkAndUnpark", "call " + CONCURRENT + "locks/LockSupport.park",
                    "call " + CONCURRENT + "locks/LockSupport.unpark"),
            // clock, console, randomness, identity
            row("currentTimeMillis", "passing.clock.PollingWithoutSleep", "call " + SYSTEM + "currentTimeMillis"),
            row("nanoTime", "passing.threads.WaysToSleep", "call " + SYSTEM + "nanoTime"),
            row("Date", "passing.clock.Dates", "new java/util/Date"),
            row("System.out", "passing.host.Console", "field " + SYSTEM + "out"),
            row("System.err", "passing.host.Console", "field " + SYSTEM + "err"),
            row("System.in", "passing.host.Console", "field " + SYSTEM + "in"),
            row("Math.random", "passing.host.Randomness", "call java/lang/Math.random"),
            row("new Random()", "passing.host.Randomness", "new java/util/Random"),
            row("hashCode of root classes", "passing.host.Identity", "call hashCode"),
            row("reflection", "passing.host.ReflectedCalls", "call java/lang/reflect/Method.invoke"),
            // ends
            row("System.exit", "passing.exit.ExitFromMain", "call " + SYSTEM + "exit"),
            row("System.exit inside finally and catch Throwable", "passing.exit.ExitInsideFinally",
                    "call " + SYSTEM + "exit"),
            row("System.exit inside takeControl", "passing.exit.ExitInsideTakeControl", "call " + SYSTEM + "exit"),
            row("Runtime.exit", "passing.exit.ExitFromAnotherThread", "call java/lang/Runtime.exit"),
            row("Runtime.halt", "passing.exit.HaltRunsNoHooks", "call java/lang/Runtime.halt"),
            row("addShutdownHook", "passing.exit.ShutdownHooks", "call java/lang/Runtime.addShutdownHook"),
            row("handlers that swallow everything", "failing.runaways.SwallowingEverything", "loop"),
            // method references
            row("Thread::sleep", "passing.threads.WaysToSleep", "reference " + THREAD + "sleep"),
            row("lock::notifyAll", "passing.monitors.MethodReferences", "reference java/lang/Object.notifyAll"),
            row("Thread::new", "passing.monitors.MethodReferences", "reference " + THREAD + "<init>"),
            // class initialisation
            row("initialiser of a class", "passing.initialisers.BlockingInitialiser", "<clinit>"),
            row("initialiser of an interface", "passing.initialisers.InterfaceConstants", "<clinit>"),
            row("initialiser of an enum", "passing.initialisers.EnumConstants", "extends java/lang/Enum"),
            row("initialiser that only computes", "passing.initialisers.TablesInTurns", "<clinit>"),
            row("initialiser of a deserialised class", "passing.initialisers.Deserialised",
                    "new java/io/ObjectInputStream"),
            row("reflection on static fields", "passing.initialisers.OnlyComputing",
                    "call java/lang/reflect/Field.getInt"),
            row("method handles", "passing.initialisers.OnlyComputing",
                    "call java/lang/invoke/MethodHandles$Lookup.findStatic"),
            row("Enum.valueOf", "passing.statics.MutableEnums", "call java/lang/Enum.valueOf"),
            row("initialiser that starts a thread", "passing.initialisers.MainClassStartsThread", "<clinit>"),
            // classes that stand for the JDK's
            row("Timer", "passing.concurrency.TimerTicks", "new java/util/Timer", "extends java/util/TimerTask"),
            row("executors", "passing.concurrency.FixedPool", "call " + CONCURRENT + "Executors.newFixedThreadPool"),
            row("scheduled executors", "passing.concurrency.ScheduledRates",
                    "call " + CONCURRENT + "Executors.newScheduledThreadPool"),
            row("fork-join pools", "passing.concurrency.ForkJoinSum", "new " + CONCURRENT + "ForkJoinPool"),
            row("fork-join threads", "passing.concurrency.ForkJoinThreads",
                    "extends " + CONCURRENT + "ForkJoinWorkerThread"),
            row("CompletableFuture", "passing.concurrency.FutureChain",
                    "call " + CONCURRENT + "CompletableFuture.supplyAsync"),
            row("FutureTask", "passing.concurrency.TimeOuts", "new " + CONCURRENT + "FutureTask"),
            row("ReentrantLock and Condition", "passing.concurrency.PingPong",
                    "new " + CONCURRENT + "locks/ReentrantLock",
                    "call " + CONCURRENT + "locks/Condition.awaitUninterruptibly"),
            row("ReentrantReadWriteLock", "passing.concurrency.ReadersAndWriter",
                    "new " + CONCURRENT + "locks/ReentrantReadWriteLock"),
            row("blocking queues", "passing.concurrency.Queues", "new " + CONCURRENT + "SynchronousQueue",
                    "new " + CONCURRENT + "DelayQueue", "new " + CONCURRENT + "LinkedBlockingQueue"),
            row("CountDownLatch", "passing.concurrency.LatchesAndBarrier", "new " + CONCURRENT + "CountDownLatch"),
            row("CyclicBarrier", "passing.concurrency.LatchesAndBarrier", "new " + CONCURRENT + "CyclicBarrier"),
            row("Semaphore", "passing.concurrency.SemaphoreTurns", "new " + CONCURRENT + "Semaphore"),
            row("Phaser and Exchanger", "passing.concurrency.PhaserAndExchanger", "extends " + CONCURRENT + "Phaser",
                    "new " + CONCURRENT + "Exchanger"),
            row("ConcurrentHashMap", "passing.concurrency.SharedMap", "new " + CONCURRENT + "ConcurrentHashMap"),
            row("Vector, Stack, Hashtable", "passing.concurrency.OldCollections", "new java/util/Vector",
                    "new java/util/Stack", "new java/util/Hashtable"),
            row("Collections.synchronized*", "passing.concurrency.VectorGuardedByItself",
                    "call java/util/Collections.synchronizedList"),
            row("StringBuffer", "passing.concurrency.SharedBuffer", "new java/lang/StringBuffer"),
            row("toString called by StringBuffer and PrintWriter", "passing.concurrency.TextOfObjects",
                    "call java/lang/StringBuffer.append", "call java/lang/StringBuffer.insert",
                    "call java/io/PrintWriter.print"),
            row("pipes", "passing.concurrency.PipedWords", "new java/io/PipedInputStream"),
            row("PrintStream", "passing.host.Console", "new java/io/PrintStream"),
            // runaways and deadlocks
            row("endless loop", "failing.runaways.EndlessLoop", "loop"),
            row("endless recursion", "failing.runaways.EndlessRecursion"),
            row("endless allocation", "failing.runaways.EndlessAllocation", "loop"),
            row("endless creation of threads", "failing.runaways.EndlessThreads", "new java/lang/Thread"),
            row("loop inside the JDK", "failing.runaways.LoopInTheJdk"),
            row("lock order", "failing.deadlocks.LockOrder", "monitor"),
            row("lost notify", "failing.deadlocks.LostNotify", "call java/lang/Object.notify"),
            row("race on a counter", "failing.races.LostUpdate"));

    private record Row(String construct, String program, List<String> contains) {}

    private static Row row(String construct, String program, String... contains) {
        return new Row(construct, program, List.of(contains));
    }

    @TestFactory
    Stream<DynamicTest> everyRowHasAProgramThatUsesIt() throws IOException {
        Set<String> programs = FixtureProgram.all().stream().map(FixtureProgram::mainClass).collect(Collectors.toSet());
        return TABLE.stream().map(row -> DynamicTest.dynamicTest(row.construct() + ": " + row.program(), () -> {
            assertThat(programs).contains("programs." + row.program());
            assertThat(Constructs.of("programs." + row.program())).containsAll(row.contains());
        }));
    }

    @Test
    void thereAreManyPrograms() throws IOException {
        assertThat(FixtureProgram.all()).hasSizeGreaterThan(100);
    }
}
