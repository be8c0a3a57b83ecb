package brickless.cli;

import brickless.loading.MissingReference;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Writes members as Java does: {@code lejos.hardware.Sound.playNote(int[], int)}. */
final class MemberText {
    private static final Map<Character, String> PRIMITIVES = Map.of('B', "byte", 'C', "char", 'D', "double",
            'F', "float", 'I', "int", 'J', "long", 'S', "short", 'Z', "boolean", 'V', "void");

    private final String descriptor;
    private int position;

    private MemberText(String descriptor) {
        this.descriptor = descriptor;
    }

    /** The class, method or field that is missing. */
    static String of(MissingReference reference) {
        String member = reference.member();
        if (member.isEmpty()) {
            return "class " + reference.owner();
        }
        int parameters = member.indexOf('(');
        if (parameters < 0) {
            return reference.owner() + "." + member.substring(0, member.indexOf(':'));
        }
        String list = "(" + String.join(", ", new MemberText(member.substring(parameters + 1)).parameters()) + ")";
        String method = member.substring(0, parameters);
        return method.equals("<init>") ? "new " + reference.owner() + list : reference.owner() + "." + method + list;
    }

    private List<String> parameters() {
        List<String> types = new ArrayList<>();
        while (descriptor.charAt(position) != ')') {
            types.add(type());
        }
        return types;
    }

    private String type() {
        char first = descriptor.charAt(position++);
        if (first == '[') {
            return type() + "[]";
        }
        if (first != 'L') {
            return PRIMITIVES.get(first);
        }
        String name = descriptor.substring(position, descriptor.indexOf(';', position));
        position += name.length() + 1;
        return name.substring(name.lastIndexOf('/') + 1);
    }
}
