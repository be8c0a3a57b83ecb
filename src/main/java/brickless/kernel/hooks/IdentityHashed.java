package brickless.kernel.hooks;

/**
 * An object that carries its own sequential identity hash; rewriting adds this interface to program classes. Shared.
 */
public interface IdentityHashed {
    /** The object's identity hash, drawn at first use. */
    int bricklessIdentityHash();
}
