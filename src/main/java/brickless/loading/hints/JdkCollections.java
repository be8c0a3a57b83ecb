package brickless.loading.hints;

import java.util.List;
import java.util.Set;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.MethodInsnNode;

/**
 * What JDK collections and wrappers do with what is known: programs keep motors in lists and maps, and numbers in boxes
 * and texts.
 */
final class JdkCollections {
    private static final Set<String> VIEWS = Set.of("iterator", "listIterator", "values", "entrySet", "clone",
            "stream", "toArray");
    private static final Set<String> LOOK_UPS = Set.of("get", "getOrDefault", "remove", "getFirst", "getLast", "next",
            "getValue", "poll", "peek", "pop", "take", "element", "elementAt", "firstElement", "lastElement");

    private final Facts facts;

    JdkCollections(Facts facts) {
        this.facts = facts;
    }

    /** What the constructor of a collection makes; null if it is no collection. */
    Clue constructed(MethodInsnNode call, List<Clue> arguments, String instruction) {
        if (!call.owner.startsWith("java/util/")) {
            return null;
        }
        Clue copied = arguments.size() == 2 ? arguments.get(1) : Clue.unknown(1);
        return copied.is(Clue.Kind.CONTAINER) ? copied : Clue.container(instruction);
    }

    /** What a call returns, noting what is put into containers; null if nothing of interest. */
    Clue returned(MethodInsnNode call, List<Clue> arguments, String instruction) {
        if (isFactory(call)) {
            return factory(call, arguments, instruction);
        }
        Clue first = arguments.isEmpty() ? Clue.unknown(1) : arguments.get(0);
        if (call.name.equals("getProperty") && arguments.size() == 3) {
            return arguments.get(2);
        }
        if (first.is(Clue.Kind.TEXT) && call.owner.startsWith("java/lang/")
                && call.name.matches("parse(Double|Float|Int)|valueOf")) {
            return parsed(first.text(), sizeOf(call));
        }
        if (call.name.equals("valueOf") || call.name.endsWith("Value") && call.owner.startsWith("java/lang/")) {
            return first.is(Clue.Kind.NUMBER) ? Clue.number(sizeOf(call), first.number()) : null;
        }
        return first.is(Clue.Kind.CONTAINER) ? held(call, arguments) : null;
    }

    private static int sizeOf(MethodInsnNode call) {
        return Type.getReturnType(call.desc).getSize();
    }

    private static Clue parsed(String text, int size) {
        return text.matches("-?\\d+(\\.\\d+)?[fd]?") ? Clue.number(size, Double.parseDouble(text)) : null;
    }

    private Clue held(MethodInsnNode call, List<Clue> arguments) {
        Clue container = arguments.get(0);
        Clue last = arguments.get(arguments.size() - 1);
        if (VIEWS.contains(call.name)) {
            return container;
        }
        if (call.name.equals("put")) {
            facts.put(container, arguments.get(1), last);
        } else if (call.name.startsWith("add") && arguments.size() > 1) {
            facts.put(container, Clue.unknown(1), last);
        } else if (LOOK_UPS.contains(call.name)) {
            return facts.get(container, arguments.size() > 1 ? arguments.get(1) : Clue.unknown(1));
        }
        return null;
    }

    private static boolean isFactory(MethodInsnNode call) {
        return call.owner.equals("java/util/Arrays") && call.name.equals("asList")
                || call.name.equals("of") && Set.of("java/util/List", "java/util/Set", "java/util/Map")
                .contains(call.owner);
    }

    private Clue factory(MethodInsnNode call, List<Clue> arguments, String instruction) {
        if (arguments.size() == 1 && arguments.get(0).is(Clue.Kind.CONTAINER)) {
            return arguments.get(0);
        }
        Clue container = Clue.container(instruction);
        boolean map = call.owner.equals("java/util/Map");
        for (int i = 0; i < arguments.size(); i += map ? 2 : 1) {
            facts.put(container, map ? arguments.get(i) : Clue.number(1, i), arguments.get(map ? i + 1 : i));
        }
        return container;
    }
}
