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
import java.util.List;

/**
 * The class loader of one robot, or of several that run the same program: defines the program, leJOS and the robots'
 * own hooks anew, rewritten as {@link LoadingRules} say, and takes everything else from the application.
 *
 * <p>Create one per program and run, {@link #newRobot} for each robot, {@link RobotContext#bind} it to its kernel
 * before any class of the program is used, run {@link #mainThread} on that, and {@link #close} the loader afterwards.
 * Nothing outside refers to it then, so that its classes can be collected. With several robots, {@link #bind} and the
 * other calls concern the robot that was entered last. Thread-safe, but for robots: one runs at a time.
 */
public final class RobotClassLoader extends ClassLoader implements Closeable {
    private static final String NAME = "robot";
    /** Exchanges its own statics. */
    private static final String HOOKS = "brickless.kernel.hooks.Hooks";

    private final LoadingRules rules;
    private final ClassLoader application;
    private final ClassSource applicationClasses;
    private final ClassSource programClasses;
    private final ClassCatalog catalog;
    private final ClassRewriter rewriter;
    /** Set before any class is defined; null unless several robots share the classes. */
    private StaticExchange exchange;

    private RobotClassLoader(ClassLoader application, ClassSource programClasses, LoadingRules rules) {
        super(NAME, getPlatformClassLoader());
        this.rules = rules;
        this.application = application;
        this.applicationClasses = new LoaderClassSource(application);
        this.programClasses = programClasses;
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

    /** A robot that runs these classes. Without {@link #forSeveralRobots} there must be one only. */
    public RobotContext newRobot() {
        return new RobotContext(this, exchange);
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
