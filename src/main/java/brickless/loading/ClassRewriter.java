package brickless.loading;

import java.util.ArrayList;
import java.util.List;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassTooLargeException;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.MethodTooLargeException;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.commons.ClassRemapper;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;

/**
 * Puts a class through all passes. The order matters: class initialisation looks at the original uses, redirects see
 * bridges, charges come after calls are final, and synchronized wraps everything.
 */
final class ClassRewriter {
    private final ClassCatalog catalog;
    private final JdkReplacements replacements;
    private final ClassInitialisers initialisers;
    private final List<ClassPass> classPasses;
    private final List<MethodPass> methodPasses;
    private final ClassPass identityHashes = new IdentityHashInjection();

    ClassRewriter(ClassCatalog catalog, JdkReplacements replacements) {
        this.catalog = catalog;
        this.replacements = replacements;
        JdkCallRedirects redirects = new JdkCallRedirects(catalog);
        ConstructedReplacements constructed = new ConstructedReplacements(replacements);
        initialisers = new ClassInitialisers(catalog, constructed);
        classPasses = List.of(new Finalizers(catalog), initialisers,
                new MethodReferenceBridges(redirects, constructed, catalog), constructed);
        methodPasses = List.of(new NewLabels(), initialisers, redirects, constructed,
                new StandardStreams(), new StringConcatenation(), new CollectionFactories(),
                new MonitorCalls(), new ArrayAllocation(), new BackEdgeCharges(), new KillThroughHandlers(),
                new CallDepth(catalog), new SynchronizedMethods());
    }

    /**
     * The rewritten class.
     *
     * @throws UnloadableClassError if the class file is damaged, too new, or too large after rewriting
     */
    RewrittenClass rewrite(ClassFile file, String name) {
        ClassReader reader = ClassFiles.reader(file, name);
        ClassNode type = new ClassNode();
        try {
            boolean meansTheJdk = JdkReplacements.isReplacement(name);
            reader.accept(meansTheJdk ? type : new ClassRemapper(type, replacements), ClassReader.EXPAND_FRAMES);
        } catch (IllegalArgumentException | IndexOutOfBoundsException damaged) {
            throw ClassFiles.damaged(file, name, damaged);
        }
        if ((type.access & Opcodes.ACC_MODULE) == 0) {
            transform(type, file);
        }
        ClassNode statics = InterfaceStatics.takeOutOf(type);
        InterfaceStatics.addToNest(type, catalog);
        initialisers.addTrigger(type.name, statics == null ? type : statics);
        return new RewrittenClass(bytes(type, file), statics == null ? null : bytes(statics, file));
    }

    private static byte[] bytes(ClassNode type, ClassFile file) {
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        try {
            type.accept(writer);
            return writer.toByteArray();
        } catch (MethodTooLargeException | ClassTooLargeException tooLarge) {
            throw new UnloadableClassError(type.name, file.origin(),
                    "too large to be rewritten: " + tooLarge.getMessage(), tooLarge);
        }
    }

    private void transform(ClassNode type, ClassFile file) {
        NativeMethods.replace(type, file.origin());
        for (ClassPass pass : classPasses) {
            pass.rewrite(type);
        }
        for (MethodNode method : new ArrayList<>(type.methods)) {
            if ((method.access & Opcodes.ACC_ABSTRACT) == 0) {
                for (MethodPass pass : methodPasses) {
                    pass.rewrite(type, method);
                }
            }
        }
        identityHashes.rewrite(type);
    }
}
