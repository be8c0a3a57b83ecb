package brickless.loading;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.objectweb.asm.ClassReader;

/**
 * Which classes of a folder of programs belong to one of them: those its main class can lead to, by reference or by a
 * text that is a class name, as reflection uses it.
 */
public final class ReachableClasses {
    private static final int CLASS_CONSTANT = 7;
    private static final int STRING_CONSTANT = 8;

    private ReachableClasses() {}

    /** The class files that the main class leads to, in the order given; all if the main class is not among them. */
    public static List<byte[]> from(String mainClass, List<byte[]> classFiles) {
        Map<String, byte[]> files = new LinkedHashMap<>();
        for (byte[] file : classFiles) {
            files.putIfAbsent(new ClassReader(file).getClassName(), file);
        }
        String main = mainClass.replace('.', '/');
        if (!files.containsKey(main)) {
            return classFiles;
        }
        Set<String> reached = new HashSet<>(Set.of(main));
        Deque<String> unread = new ArrayDeque<>(reached);
        while (!unread.isEmpty()) {
            for (String name : named(files.get(unread.remove()))) {
                if (files.containsKey(name) && reached.add(name)) {
                    unread.add(name);
                }
            }
        }
        List<byte[]> used = new ArrayList<>();
        files.forEach((name, file) -> {
            if (reached.contains(name)) {
                used.add(file);
            }
        });
        return used;
    }

    /** What may be names of classes in the constants of a class file; internal names. */
    private static List<String> named(byte[] classFile) {
        ClassReader reader = new ClassReader(classFile);
        char[] buffer = new char[reader.getMaxStringLength()];
        List<String> names = new ArrayList<>();
        for (int i = 1; i < reader.getItemCount(); i++) {
            int item = reader.getItem(i);
            int tag = item == 0 ? 0 : reader.readByte(item - 1);
            if (tag == CLASS_CONSTANT || tag == STRING_CONSTANT) {
                names.add(elementOf(reader.readUTF8(item, buffer).replace('.', '/')));
            }
        }
        return names;
    }

    private static String elementOf(String name) {
        boolean array = name.startsWith("[") && name.endsWith(";");
        return array ? name.substring(name.lastIndexOf('[') + 2, name.length() - 1) : name;
    }
}
