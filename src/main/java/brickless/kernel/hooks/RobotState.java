package brickless.kernel.hooks;

import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Properties;

/**
 * What the hooks keep for one robot. The counters of the robot that has the processor are in {@link Hooks}, where
 * rewritten code reaches them fast; those of another one are here. Per robot.
 */
final class RobotState extends StaticState implements Budget {
    final VirtualMachine machine;
    final int largestDepth;
    final long largestArrayBytes;
    /** Of the classes whose initialisation has begun. */
    final Map<Class<?>, ClassInitialization.Progress> initialisations = new IdentityHashMap<>();
    /** Constants of enums by name, of those enums that were asked. */
    final Map<Class<?>, Map<String, Enum<?>>> enums = new IdentityHashMap<>();
    final IdentityHashes identityHashes = new IdentityHashes();
    /** Null until the program asks. */
    Properties properties;
    private int left;
    private int depth;

    /** The state of a robot whose kernel is {@code machine}; of rewritten code without a kernel if that is null. */
    RobotState(VirtualMachine kernel) {
        machine = kernel == null ? new HostMachine() : kernel;
        largestDepth = kernel == null ? Integer.MAX_VALUE : InstructionCharges.LARGEST_CALL_DEPTH;
        largestArrayBytes = kernel == null ? Long.MAX_VALUE : InstructionCharges.LARGEST_ARRAY_BYTES;
    }

    /** Lets go of the program's objects: the robot is over, but its kernel still knows this. */
    void forget() {
        properties = null;
        enums.clear();
    }

    private boolean isPresent() {
        return Hooks.robot() == this;
    }

    @Override
    public int left() {
        return isPresent() ? Hooks.left : left;
    }

    @Override
    public void grant(int nanos) {
        if (isPresent()) {
            Hooks.left = nanos;
        } else {
            left = nanos;
        }
    }

    @Override
    public int depth() {
        return isPresent() ? Hooks.depth : depth;
    }

    @Override
    public void depth(int restored) {
        if (isPresent()) {
            Hooks.depth = restored;
        } else {
            depth = restored;
        }
    }

    @Override
    public void save() {
        left = Hooks.left;
        depth = Hooks.depth;
    }

    @Override
    public boolean isFinal() {
        return false;
    }

    @Override
    public void load() {
        Hooks.left = left;
        Hooks.depth = depth;
        Hooks.use(this);
    }
}
