package brickless.loading;

import brickless.kernel.hooks.Budget;
import brickless.kernel.hooks.VirtualMachine;
import brickless.loading.LoadingRules.Treatment;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URL;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Enumeration;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The class loader of one robot, or of several that run the same program: defines the program, leJOS and the robots'
 * own hooks anew, rewritten as {@link LoadingRules} say, and takes everything else from the application.
 *
 * <p>Create one per program and run, {@link #newRobot} for each robot, {@link RobotContext#bind} it to its kernel
 * before any class of the program is used, run {@link #mainThread} on that, and {@link #close} the loader afterwards.
 * Nothing outside refers to it then, so that its classes can be collected. With several robots, {@link #bind} and the
 * other calls concern the robot that was entered last. Thread-safe, but for robots: one runs at a time.
 *
 * <p>Robots of a later run are several robots too: after {@link #forget}, and {@link #reopen} if the program is in
 * directories and jars, the loader can be used again.
 */
public final class RobotClassLoader extends ClassLoader implements Closeable {
    private static final String NAME = "robot";
    /** Exchanges its own statics. */
    private static final String HOOKS = "brickless.kernel.hooks.Hooks";

    private final LoadingRules rules;
    private final ClassLoader application;
    /** Whether the program is read by it too. */
    private final boolean fromApplication;
    private final ClassSource applicationClasses;
    private final RememberedClasses programClasses;
    private final ClassCatalog catalog;
    private final ClassRewriter rewriter;
    /** Set before any class is defined; null unless several robots share the classes. */
    private StaticExchange exchange;
    /** Whether a class could not be loaded: the JVM remembers that, and tells it differently the second time. */
    private volatile boolean missedOne;
    /** Classes of the program without obstacle to reuse; of a loader with one nothing more is asked. */
    private final Set<String> withoutObstacle = new HashSet<>();

    private RobotClassLoader(ClassLoader application, ClassSource programClasses, LoadingRules rules) {
        super(NAME, getPlatformClassLoader());
        this.rules = rules;
        this.application = application;
        fromApplication = programClasses instanceof LoaderClassSource;
        this.applicationClasses = new LoaderClassSource(application);
        this.programClasses = new RememberedClasses(programClasses);
        JdkReplacements replacements = JdkReplacements.standard();
        catalog = new ClassCatalog(this::rewritable, replacements);
        rewriter = new ClassRewriter(catalog, replacements);
    }

    /**
     * A loader for a program in directories and jars.
     *
     * @throws IOException if one of them does not exist or is no readable jar; the message names it
     */
    public static RobotClassLoader ofPaths(List<Path> classPath) throws IOException {
        return ofPaths(classPath, LoadingRules.standard());
    }

    /** Like {@link #ofPaths(List)} with other rules. */
    public static RobotClassLoader ofPaths(List<Path> classPath, LoadingRules rules) throws IOException {
        return new RobotClassLoader(RobotClassLoader.class.getClassLoader(), new PathClassSource(classPath), rules);
    }

    /**
     * A loader for a program on the application's own class path, as in JUnit tests; see
     * {@link #ofApplication(ClassLoader, LoadingRules)}.
     */
    public static RobotClassLoader ofApplication() {
        return ofApplication(RobotClassLoader.class.getClassLoader(), LoadingRules.standard());
    }

    /**
     * A loader for a program whose class files another loader can read.
     *
     * @param application the loader that reads them and supplies the shared classes
     * @param rules who is rewritten
     */
    public static RobotClassLoader ofApplication(ClassLoader application, LoadingRules rules) {
        return new RobotClassLoader(application, new LoaderClassSource(application), rules);
    }

    /** Prepares for several robots; to be called before any class is loaded. */
    public RobotClassLoader forSeveralRobots() {
        exchange = new StaticExchange();
        ProgramEntry.listen(this, exchange::initialisationBegins);
        return this;
    }

    /**
     * Why a later run must not use the classes; empty if it may. To be asked while the class path is still open.
     */
    public Optional<String> obstacleToReuse() {
        if (exchange == null || missedOne) {
            return Optional.of(exchange == null ? "prepared for one robot" : "a class could not be loaded");
        }
        List<String> found = programClasses.found();
        found.removeAll(withoutObstacle);
        withoutObstacle.addAll(found);
        return SharingObstacles.firstIn(this, found);
    }

    /** Whether this is a loader of {@link #ofApplication(ClassLoader, LoadingRules)} for that one, with these rules. */
    public boolean readsFrom(ClassLoader other, LoadingRules otherRules) {
        return fromApplication && application == other && rules == otherRules;
    }

    /**
     * Opens another class path for a loader of {@link #ofPaths(List)}, which may have been closed, if the program is
     * the same: all classes that were looked for so far are there with the same content, or absent as before.
     *
     * @return whether it is
     * @throws IOException if a directory or jar does not exist or cannot be read; the message names it
     */
    public boolean reopen(List<Path> classPath) throws IOException {
        if (fromApplication) {
            return false;
        }
        ClassSource other = new PathClassSource(classPath);
        if (!programClasses.agreesWith(other)) {
            other.close();
            return false;
        }
        programClasses.exchange(other);
        return true;
    }

    /**
     * Lets go of everything that robots have left in static fields: these have the values again that the JVM gave them.
     * All robots must be over.
     */
    public void forget() {
        bind(null);
        exchange.clear(this);
    }

    /** A robot that runs these classes. Without {@link #forSeveralRobots} there must be one only. */
    public RobotContext newRobot() {
        RobotContext robot = new RobotContext(this, exchange);
        if (exchange != null) {
            exchange.joins(robot);
        }
        return robot;
    }

    /**
     * Connects this robot's hooks to its kernel; null disconnects them. Without a kernel rewritten classes behave as
     * plain ones.
     *
     * @return the kernel's access to the robot's budget counters
     */
    public Budget bind(VirtualMachine kernel) {
        return ProgramEntry.bind(this, kernel);
    }

    /**
     * The program's main thread, not started: the kernel runs it as its first fibre. Call after {@link #bind}. The body
     * initialises the class and calls {@code main}; exceptions of the program come out of it as they are.
     *
     * @param mainClass binary name of a class with a {@code public static void main(String[])}
     */
    public Thread mainThread(String mainClass, String... arguments) {
        return programThread("main", () -> ProgramEntry.callMain(this, mainClass, arguments));
    }

    /**
     * Any other first thread of a program, not started; {@code body} may use the robot's classes. Call after
     * {@link #bind}.
     */
    public Thread programThread(String name, Runnable body) {
        return ProgramEntry.newThread(this, body, name);
    }

    /**
     * A class of the robot, initialised as the program would. Call on a thread of the program.
     */
    public Class<?> initialized(String name) {
        return ProgramEntry.initialized(this, name);
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        synchronized (getClassLoadingLock(name)) {
            Class<?> type = findLoadedClass(name);
            if (type == null) {
                type = rules.of(name) == Treatment.SHARED ? loadShared(name) : findClass(name);
            }
            if (resolve) {
                resolveClass(type);
            }
            return type;
        }
    }

    private Class<?> loadShared(String name) throws ClassNotFoundException {
        try {
            return application.loadClass(name);
        } catch (ClassNotFoundException absent) {
            return findClass(name);
        }
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        boolean loaded = InterfaceStatics.isName(name);
        try {
            Class<?> type = define(name);
            loaded = true;
            return type;
        } finally {
            missedOne |= !loaded;
        }
    }

    private Class<?> define(String name) throws ClassNotFoundException {
        ClassFile file = locate(InterfaceStatics.interfaceOf(name));
        byte[] bytes = file == null ? null : bytesOf(name, file);
        if (bytes == null) {
            throw new ClassNotFoundException(name);
        }
        Class<?> type = defineClass(name, bytes, 0, bytes.length);
        if (exchange != null && !name.equals(HOOKS)) {
            exchange.defined(type, bytes);
        }
        return type;
    }

    private byte[] bytesOf(String name, ClassFile file) {
        if (rules.of(name) == Treatment.PER_ROBOT_PLAIN) {
            return file.bytes();
        }
        RewrittenClass rewritten = rewritten(InterfaceStatics.interfaceOf(name).replace('.', '/'), file);
        return InterfaceStatics.isName(name) ? rewritten.statics() : rewritten.bytes();
    }

    private synchronized RewrittenClass rewritten(String internalName, ClassFile file) {
        String key = RewrittenClassCache.key(file.bytes());
        RewrittenClass known = RewrittenClassCache.shared().find(key, catalog::summary);
        if (known != null) {
            return known;
        }
        catalog.takeConsulted();
        RewrittenClass rewritten = rewriter.rewrite(file, internalName);
        RewrittenClassCache.shared().store(key, rewritten, catalog.takeConsulted());
        return rewritten;
    }

    private ClassFile locate(String name) {
        String internalName = name.replace('.', '/');
        ClassFile file = rules.isOurs(name) ? applicationClasses.find(internalName) : null;
        return file == null ? programClasses.find(internalName) : file;
    }

    /** The file of a class that is rewritten; null for any other class. */
    private ClassFile rewritable(String internalName) {
        String name = internalName.replace('/', '.');
        return rules.of(name) == Treatment.PER_ROBOT_REWRITTEN ? locate(name) : null;
    }

    /** The file of a class of the program itself, not of leJOS or the simulator; null for any other class. */
    ClassFile programClass(String internalName) {
        boolean ours = internalName.startsWith("[") || rules.isOurs(internalName.replace('/', '.'));
        return ours ? null : rewritable(internalName);
    }

    @Override
    public URL getResource(String path) {
        Enumeration<URL> all = getResources(path);
        return all.hasMoreElements() ? all.nextElement() : null;
    }

    @Override
    public Enumeration<URL> getResources(String path) {
        List<URL> all = new ArrayList<>();
        try {
            all.addAll(programClasses.resources(path));
            all.addAll(Collections.list(getPlatformClassLoader().getResources(path)));
            if (all.isEmpty() && rules.isOurs(path.replace('/', '.'))) {
                all.addAll(applicationClasses.resources(path));
            }
        } catch (IOException unreadable) {
            throw new UncheckedIOException("resource " + path, unreadable);
        }
        return Collections.enumeration(all);
    }

    /** Closes the program's jars. Classes that are loaded stay usable. */
    @Override
    public void close() throws IOException {
        programClasses.close();
    }
}
