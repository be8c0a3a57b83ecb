package brickless.loading;

import org.objectweb.asm.tree.ClassNode;

/** One concern of rewriting that changes a class as a whole. Stateless. */
interface ClassPass {
    /** Rewrites the class in place. */
    void rewrite(ClassNode type);
}
