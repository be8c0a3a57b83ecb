package brickless.loading.hints;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.IntInsnNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.analysis.Interpreter;

/** Interprets one method symbolically; what it finds goes into {@link Facts}. */
final class HintInterpreter extends Interpreter<Clue> implements Opcodes {
    /** Prefix of what an object of a class of the program is. */
    private static final String INSTANCE = "instance of ";

    private final Facts facts;
    private final LejosCalls calls;
    private final JdkCollections collections;
    private final String method;
    private final Map<AbstractInsnNode, Integer> places;
    private int parameter;

    HintInterpreter(Facts facts, String method, Map<AbstractInsnNode, Integer> places) {
        super(ASM9);
        this.facts = facts;
        this.calls = new LejosCalls(facts);
        this.collections = new JdkCollections(facts);
        this.method = method;
        this.places = places;
    }

    @Override
    public Clue newValue(Type type) {
        return type == Type.VOID_TYPE ? null : Clue.unknown(type == null ? 1 : type.getSize());
    }

    @Override
    public Clue newParameterValue(boolean isInstanceMethod, int local, Type type) {
        if (isInstanceMethod && local == 0) {
            return newValue(type);
        }
        Clue known = facts.at(method + "#" + parameter++);
        return known == null || known.size() != type.getSize() ? newValue(type) : known;
    }

    @Override
    public Clue newOperation(AbstractInsnNode instruction) {
        int opcode = instruction.getOpcode();
        if (opcode >= ICONST_M1 && opcode <= ICONST_5) {
            return Clue.number(1, opcode - ICONST_0);
        }
        if (opcode == LCONST_0 || opcode == LCONST_1) {
            return Clue.number(2, opcode - LCONST_0);
        }
        if (opcode >= FCONST_0 && opcode <= FCONST_2) {
            return Clue.number(1, opcode - FCONST_0);
        }
        if (opcode == DCONST_0 || opcode == DCONST_1) {
            return Clue.number(2, opcode - DCONST_0);
        }
        if (instruction instanceof IntInsnNode push) {
            return Clue.number(1, push.operand);
        }
        if (instruction instanceof LdcInsnNode constant) {
            return ofConstant(constant.cst);
        }
        if (opcode == GETSTATIC) {
            return field((FieldInsnNode) instruction);
        }
        return opcode == NEW ? Clue.object(nameOf(instruction)) : Clue.unknown(1);
    }

    private String nameOf(AbstractInsnNode instruction) {
        return method + "@" + places.get(instruction);
    }

    static Clue ofConstant(Object constant) {
        if (constant instanceof Number number) {
            return Clue.number(number instanceof Double || number instanceof Long ? 2 : 1, number.doubleValue());
        }
        return constant instanceof String text ? Clue.text(text) : Clue.unknown(1);
    }

    private Clue field(FieldInsnNode access) {
        Clue brick = LejosCalls.constant(access.owner, access.name);
        if (brick != null) {
            return brick;
        }
        Clue known = facts.at(access.owner + "." + access.name);
        int size = Type.getType(access.desc).getSize();
        return known == null || known.size() != size ? Clue.unknown(size) : known;
    }

    @Override
    public Clue copyOperation(AbstractInsnNode instruction, Clue value) {
        return resolved(value);
    }

    private Clue resolved(Clue value) {
        if (!value.is(Clue.Kind.OBJECT)) {
            return value;
        }
        Clue made = facts.at(value.text());
        return made == null ? value : made;
    }

    @Override
    public Clue unaryOperation(AbstractInsnNode instruction, Clue value) {
        switch (instruction.getOpcode()) {
            case INEG, FNEG, LNEG, DNEG:
                return arithmetic(value.size(), -value.number());
            case I2L, I2D, F2D, F2L, L2D, D2L:
                return arithmetic(2, value.number());
            case I2F, L2I, L2F, F2I, D2I, D2F:
                return arithmetic(1, value.number());
            case CHECKCAST:
                return resolved(value);
            case IINC:
                return Clue.counter();
            case NEWARRAY, ANEWARRAY:
                return Clue.container(nameOf(instruction));
            case PUTSTATIC:
                put((FieldInsnNode) instruction, value);
                return null;
            case GETFIELD:
                return field((FieldInsnNode) instruction);
            default:
                return Clue.unknown(1);
        }
    }

    private void put(FieldInsnNode access, Clue value) {
        Clue known = resolved(value);
        facts.learn(access.owner + "." + access.name, known);
        facts.named(known, access.name);
        facts.number(access.name, known);
    }

    private static Clue arithmetic(int size, double value) {
        return Double.isNaN(value) ? Clue.unknown(size) : Clue.number(size, value);
    }

    @Override
    public Clue binaryOperation(AbstractInsnNode instruction, Clue a, Clue b) {
        switch (instruction.getOpcode()) {
            case IADD, FADD, LADD, DADD:
                return arithmetic(a.size(), a.number() + b.number());
            case ISUB, FSUB, LSUB, DSUB:
                return arithmetic(a.size(), a.number() - b.number());
            case IMUL, FMUL, LMUL, DMUL:
                return arithmetic(a.size(), a.number() * b.number());
            case FDIV, DDIV:
                return arithmetic(a.size(), a.number() / b.number());
            case PUTFIELD:
                put((FieldInsnNode) instruction, b);
                return null;
            case IALOAD, FALOAD, AALOAD, LALOAD, DALOAD:
                return element(a, b, instruction.getOpcode() == LALOAD || instruction.getOpcode() == DALOAD ? 2 : 1);
            case LCMP, FCMPL, FCMPG, DCMPL, DCMPG, BALOAD, CALOAD, SALOAD:
                return Clue.unknown(1);
            default:
                return Clue.unknown(a.size());
        }
    }

    private Clue element(Clue array, Clue index, int size) {
        Clue held = array.is(Clue.Kind.CONTAINER) ? facts.get(array, index) : null;
        return held == null || held.size() != size ? Clue.unknown(size) : held;
    }

    @Override
    public Clue ternaryOperation(AbstractInsnNode instruction, Clue array, Clue index, Clue value) {
        if (array.is(Clue.Kind.CONTAINER)) {
            facts.put(array, index, resolved(value));
        }
        return null;
    }

    @Override
    public Clue naryOperation(AbstractInsnNode instruction, List<? extends Clue> values) {
        if (!(instruction instanceof MethodInsnNode call)) {
            return Clue.unknown(1);
        }
        List<Clue> arguments = values.stream().map(this::resolved).toList();
        int first = call.getOpcode() == INVOKESTATIC ? 0 : 1;
        for (int i = first; i < arguments.size(); i++) {
            facts.learn(call.owner + "." + call.name + call.desc + "#" + (i - first), arguments.get(i));
        }
        if (call.name.equals("<init>")) {
            constructed(call, values.get(0), arguments);
            return null;
        }
        Clue answer = calls.returned(call, arguments);
        answer = answer == null ? collections.returned(call, arguments, nameOf(call)) : answer;
        if (answer == null) {
            answer = narrowed(facts.at(call.owner + "." + call.name + call.desc), arguments);
        }
        int size = Type.getReturnType(call.desc).getSize();
        return size == 0 ? null : answer == null || answer.size() != size ? Clue.unknown(size) : answer;
    }

    private void constructed(MethodInsnNode call, Clue object, List<Clue> arguments) {
        Clue made = calls.constructed(call, arguments);
        made = made == null ? narrowed(facts.at(INSTANCE + call.owner), arguments) : made;
        if (object.is(Clue.Kind.OBJECT)) {
            facts.learn(object.text(), made == null ? collections.constructed(call, arguments, object.text()) : made);
        } else if (!object.known() && method.contains(".<init>") && made != null && made.is(Clue.Kind.DEVICE)) {
            instance(made);
        }
    }

    /** The class of this constructor is a device, because its superclass is. */
    private void instance(Clue device) {
        String own = method.substring(0, method.indexOf(".<init>"));
        facts.learn(INSTANCE + own, device);
        device.ports().forEach(port ->
                facts.named(device.at(new TreeSet<>(Set.of(port))), own.substring(own.lastIndexOf('/') + 1)));
    }

    /** What a method or class makes at the ports it is given, it makes this time at these. */
    private Clue narrowed(Clue answer, List<Clue> arguments) {
        if (answer == null || answer.ports().size() < 2) {
            return answer;
        }
        return arguments.stream().map(Clue::ports)
                .filter(ports -> !ports.isEmpty() && answer.ports().containsAll(ports)).findFirst()
                .map(ports -> offset(answer.at(ports), arguments)).orElse(answer);
    }

    /** A method that makes wheels takes their offset, if it takes a single number. */
    private Clue offset(Clue made, List<Clue> arguments) {
        List<Clue> numbers = arguments.stream().filter(argument -> argument.is(Clue.Kind.NUMBER)).toList();
        if (!made.is(Clue.Kind.WHEEL) || Double.isNaN(made.axle().offset()) || numbers.size() != 1) {
            return made;
        }
        Axle axle = made.axle().atOffset(numbers.get(0).number());
        facts.wheel(made.ports(), axle);
        return Clue.wheel(made.ports(), axle);
    }

    @Override
    public void returnOperation(AbstractInsnNode instruction, Clue value, Clue expected) {
        facts.returned(method, resolved(value));
    }

    @Override
    public Clue merge(Clue a, Clue b) {
        if (a.equals(b)) {
            return a;
        }
        Clue either = a.or(b);
        return either.size() == Math.min(a.size(), b.size()) ? either : Clue.unknown(1);
    }
}
