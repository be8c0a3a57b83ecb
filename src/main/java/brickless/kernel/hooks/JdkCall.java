package brickless.kernel.hooks;

import java.lang.invoke.MethodType;
import java.util.Locale;

/**
 * One line of the table of redirected JDK calls. Names are internal ({@code java/lang/Thread}). Shared.
 *
 * @param kind how the call is redirected
 * @param firstJdk first JDK that has the member, 0 = any
 * @param lastJdk last JDK that has it; calls of it are redirected on later ones too
 * @param owner class that declares the member
 * @param name name of the member
 * @param descriptor its descriptor
 * @param hook what to call instead; for {@link Kind#NEW} several, separated by commas
 */
public record JdkCall(Kind kind, int firstJdk, int lastJdk, String owner, String name, String descriptor, String hook) {
    /** How a call is redirected; the table's comment explains. */
    public enum Kind { STATIC, VIRTUAL, FINAL, NEW, ARGUMENT }

    private static final String HOOKS = "brickless/kernel/hooks/";
    private static final String STRICT_MATH = "StrictMath";

    /** Reads one line: kind, member, hook. */
    static JdkCall parse(String line) {
        String[] words = line.trim().split("\\s+");
        String[] kind = words[0].split("@");
        int jdk = kind.length > 1 ? Integer.parseInt(kind[1]) : 0;
        int dot = words[1].indexOf('.');
        int arguments = words[1].indexOf('(');
        return new JdkCall(Kind.valueOf(kind[0].toUpperCase(Locale.ROOT)),
                Math.max(jdk, 0), jdk < 0 ? -jdk : Integer.MAX_VALUE,
                words[1].substring(0, dot), words[1].substring(dot + 1, arguments), words[1].substring(arguments),
                words[2]);
    }

    /** Name and descriptor, such as {@code sleep(J)V}. */
    public String signature() {
        return name + descriptor;
    }

    /** Internal name of the class that has the hook. */
    public String hookOwner() {
        return ownerOf(hook);
    }

    /** Name of the hook method. */
    public String hookName() {
        int arguments = hook.indexOf('(');
        return hook.substring(hook.indexOf('.') + 1, arguments < 0 ? hook.length() : arguments);
    }

    /** Descriptor of the hook method; for {@link Kind#NEW} see {@link #suppliers}. */
    public String hookDescriptor() {
        switch (kind) {
            case VIRTUAL:
            case FINAL:
                return "(L" + owner + ";" + descriptor.substring(1);
            case ARGUMENT:
                return hook.substring(hook.indexOf('('));
            default:
                return descriptor;
        }
    }

    /** The member's descriptor after the conversion of a {@link Kind#ARGUMENT}. */
    public String convertedDescriptor() {
        MethodType converter = type(hookDescriptor());
        MethodType member = type(descriptor);
        int kept = member.parameterCount() - converter.parameterCount();
        return member.dropParameterTypes(kept, member.parameterCount()).appendParameterTypes(converter.returnType())
                .toMethodDescriptorString();
    }

    private static MethodType type(String descriptor) {
        return MethodType.fromMethodDescriptorString(descriptor, ClassLoader.getPlatformClassLoader());
    }

    /** The hooks that supply further constructor arguments, each as owner, name and descriptor. */
    public String[][] suppliers() {
        String[] hooks = hook.split(",");
        String[][] suppliers = new String[hooks.length][];
        for (int i = 0; i < hooks.length; i++) {
            int arguments = hooks[i].indexOf('(');
            suppliers[i] = new String[] {ownerOf(hooks[i]), hooks[i].substring(hooks[i].indexOf('.') + 1, arguments),
                hooks[i].substring(arguments)};
        }
        return suppliers;
    }

    private static String ownerOf(String hook) {
        String simpleName = hook.substring(0, hook.indexOf('.'));
        return STRICT_MATH.equals(simpleName) ? "java/lang/StrictMath" : HOOKS + simpleName;
    }
}
