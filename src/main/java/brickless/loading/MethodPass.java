package brickless.loading;

import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;

/**
 * One concern of rewriting that changes code, method by method. Stateless. Insertions are straight-line, so that frames
 * stay valid.
 */
interface MethodPass {
    /** Rewrites a method that has code, in place. */
    void rewrite(ClassNode type, MethodNode method);
}
