package brickless.loading.hints;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.LocalVariableNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.VarInsnNode;
import org.objectweb.asm.tree.analysis.Analyzer;
import org.objectweb.asm.tree.analysis.AnalyzerException;
import org.objectweb.asm.tree.analysis.Frame;

/**
 * Reads a program's classes for what they say about the robot.
 *
 * <p>All methods are interpreted symbolically, several times over, so that a port that travels through fields,
 * arguments and results is still recognised where a motor is made of it. Branches are not decided: what may happen
 * counts.
 */
public final class HintFinder {
    private static final int PASSES = 7;
    /** Passes for arguments alone: how many calls deep they travel before results of methods are believed. */
    private static final int ARGUMENT_PASSES = 2;
    private static final Set<Integer> STORES = Set.of(Opcodes.ASTORE, Opcodes.ISTORE, Opcodes.FSTORE, Opcodes.DSTORE);

    private HintFinder() {}

    /** Finds the hints in the class files of a program, in the order given. */
    public static HardwareHints find(List<byte[]> classFiles) {
        List<ClassNode> classes = new ArrayList<>();
        for (byte[] bytes : classFiles) {
            ClassNode node = new ClassNode();
            new ClassReader(bytes).accept(node, ClassReader.SKIP_FRAMES);
            classes.add(node);
        }
        Facts facts = new Facts();
        classes.forEach(type -> constants(type, facts));
        for (int pass = 0; pass < PASSES; pass++) {
            if (pass == ARGUMENT_PASSES) {
                facts.argumentsArrived();
            }
            for (ClassNode type : classes) {
                type.methods.forEach(method -> interpret(type, method, facts));
            }
        }
        return facts.hints();
    }

    private static void constants(ClassNode type, Facts facts) {
        for (FieldNode field : type.fields) {
            if (field.value != null) {
                Clue constant = HintInterpreter.ofConstant(field.value);
                facts.learn(type.name + "." + field.name, constant);
                facts.number(field.name, constant);
            }
        }
    }

    private static void interpret(ClassNode type, MethodNode method, Facts facts) {
        Map<AbstractInsnNode, Integer> places = new IdentityHashMap<>();
        int place = 0;
        for (AbstractInsnNode instruction : method.instructions) {
            places.put(instruction, place++);
            if (instruction instanceof FieldInsnNode access && access.owner.equals("lejos/hardware/motor/Motor")
                    && access.name.matches("[A-D]")) {
                facts.device(access.name, "NXTRegulatedMotor");
            }
        }
        HintInterpreter interpreter = new HintInterpreter(facts, type.name + "." + method.name + method.desc, places);
        names(method, frames(interpreter, type, method), places, facts);
    }

    /**
     * The interpreted method; nothing for code that ASM cannot follow: its devices are plugged in when they are opened.
     */
    private static Frame<Clue>[] frames(HintInterpreter interpreter, ClassNode type, MethodNode method) {
        try {
            return new Analyzer<>(interpreter).analyze(type.name, method);
        } catch (AnalyzerException cannotBeFollowed) {
            @SuppressWarnings({"unchecked", "rawtypes"}) Frame<Clue>[] none = new Frame[method.instructions.size()];
            return none;
        }
    }

    private static void names(MethodNode method, Frame<Clue>[] frames, Map<AbstractInsnNode, Integer> places,
            Facts facts) {
        for (AbstractInsnNode instruction : method.instructions) {
            if (!STORES.contains(instruction.getOpcode()) || frames[places.get(instruction)] == null
                    || method.localVariables == null) {
                continue;
            }
            Frame<Clue> frame = frames[places.get(instruction)];
            Clue stored = frame.getStack(frame.getStackSize() - 1);
            int local = ((VarInsnNode) instruction).var;
            for (LocalVariableNode variable : method.localVariables) {
                if (variable.index == local) {
                    facts.named(stored, variable.name);
                    facts.number(variable.name, stored);
                }
            }
        }
    }
}
