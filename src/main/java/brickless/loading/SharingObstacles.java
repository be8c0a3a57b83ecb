package brickless.loading;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.objectweb.asm.ClassReader;

/**
 * Finds out why robots should not share the classes of a program: it uses something that the JDK or the JVM remembers
 * for each class or call site, so that one robot could see objects of another. Looks at all classes that the main
 * classes lead to.
 */
public final class SharingObstacles {
    /** The JDK keeps enum constants, loaded services and the like for each class; constants of call sites stay. */
    private static final Set<String> CLASSES = Set.of(
            "java/util/EnumSet", "java/util/EnumMap", "java/util/ResourceBundle", "java/util/ServiceLoader",
            "java/io/ObjectInputStream", "java/io/ObjectOutputStream",
            "java/lang/runtime/SwitchBootstraps", "java/lang/invoke/MutableCallSite",
            "java/lang/invoke/VolatileCallSite", "java/lang/ClassLoader", ReferenceReader.COMPUTED_CONSTANT);
    /** Constants by the class, annotations with constants in them, and classes that cannot be foreseen. */
    private static final List<String> MEMBERS = List.of("java/lang/Class.getEnumConstants", "java/lang/Class.forName",
            "java/lang/Class.getAnnotation", "java/lang/Class.getDeclaredAnnotation",
            "java/lang/reflect/Method.getAnnotation", "java/lang/reflect/Method.getDeclaredAnnotation",
            "java/lang/reflect/Field.getAnnotation", "java/lang/reflect/Field.getDeclaredAnnotation",
            "java/lang/reflect/AnnotatedElement.");

    private final RobotClassLoader loader;
    private final Deque<String> open = new ArrayDeque<>();
    private final Set<String> seen = new HashSet<>();
    private String obstacle;

    private SharingObstacles(RobotClassLoader loader) {
        this.loader = loader;
    }

    /** The first obstacle in programs, in words; empty if there is none. Defines no class. */
    public static Optional<String> firstIn(RobotClassLoader loader, Collection<String> mainClasses) {
        SharingObstacles obstacles = new SharingObstacles(loader);
        for (String mainClass : mainClasses) {
            String name = mainClass.replace('.', '/');
            if (loader.programClass(name) == null) {
                return Optional.of("no class " + mainClass + " on the class path");
            }
            obstacles.lookAt(name);
        }
        obstacles.search();
        return Optional.ofNullable(obstacles.obstacle);
    }

    private void search() {
        while (obstacle == null && !open.isEmpty()) {
            String name = open.pop();
            ClassFile file = loader.programClass(name);
            if (file != null) {
                ClassReader reader = ClassFiles.reader(file, name);
                reader.accept(new ReferenceReader((reference, user, line) -> check(reference, user)),
                        ClassReader.SKIP_FRAMES);
            }
        }
    }

    private void lookAt(String name) {
        if (seen.add(name)) {
            open.add(name);
        }
    }

    private void check(ReferenceReader.Reference reference, String user) {
        if (obstacle == null && isOne(reference)) {
            obstacle = user.replace('/', '.') + " uses " + text(reference);
        }
        lookAt(reference.owner());
    }

    /** Whether a class or member must not be used. */
    static boolean isOne(ReferenceReader.Reference reference) {
        return CLASSES.contains(reference.owner()) || MEMBERS.stream().anyMatch(text(reference)::startsWith);
    }

    private static String text(ReferenceReader.Reference reference) {
        return reference.owner() + "." + reference.member();
    }
}
