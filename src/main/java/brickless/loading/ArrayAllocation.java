package brickless.loading;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.InsnList;
import org.objectweb.asm.tree.InsnNode;
import org.objectweb.asm.tree.IntInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.MultiANewArrayInsnNode;

/**
 * New arrays are charged for, and refused when the brick could not hold them. Of arrays of arrays the two innermost
 * lengths count.
 */
final class ArrayAllocation implements MethodPass {
    private static final int REFERENCE_BYTES = 4;

    @Override
    public void rewrite(ClassNode type, MethodNode method) {
        for (AbstractInsnNode node : method.instructions.toArray()) {
            InsnList code = new InsnList();
            if (node.getOpcode() == Opcodes.NEWARRAY || node.getOpcode() == Opcodes.ANEWARRAY) {
                code.add(new InsnNode(Opcodes.DUP));
                code.add(Code.push(elementBytes(node)));
                code.add(Code.call(Code.HOOKS, "allocate", "(II)V"));
            } else if (node instanceof MultiANewArrayInsnNode) {
                boolean one = ((MultiANewArrayInsnNode) node).dims == 1;
                code.add(new InsnNode(one ? Opcodes.DUP : Opcodes.DUP2));
                code.add(Code.push(innermostBytes((MultiANewArrayInsnNode) node)));
                code.add(Code.call(Code.HOOKS, "allocate", one ? "(II)V" : "(III)V"));
            }
            method.instructions.insertBefore(node, code);
        }
    }

    private static int elementBytes(AbstractInsnNode node) {
        if (node.getOpcode() == Opcodes.ANEWARRAY) {
            return REFERENCE_BYTES;
        }
        switch (((IntInsnNode) node).operand) {
            case Opcodes.T_BOOLEAN:
            case Opcodes.T_BYTE:
                return Byte.BYTES;
            case Opcodes.T_CHAR:
            case Opcodes.T_SHORT:
                return Short.BYTES;
            case Opcodes.T_LONG:
            case Opcodes.T_DOUBLE:
                return Long.BYTES;
            default:
                return Integer.BYTES;
        }
    }

    private static int innermostBytes(MultiANewArrayInsnNode node) {
        char element = node.desc.charAt(node.dims);
        switch (element) {
            case 'Z':
            case 'B':
                return Byte.BYTES;
            case 'C':
            case 'S':
                return Short.BYTES;
            case 'J':
            case 'D':
                return Long.BYTES;
            default:
                return Integer.BYTES;
        }
    }
}
