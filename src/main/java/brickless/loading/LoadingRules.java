package brickless.loading;

import java.lang.module.ModuleFinder;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Who defines which class, as data: the first rule that fits a class name decides. Immutable.
 *
 * <p>What a robot must have for itself (its program, leJOS, everything with static state of the robot) is defined per
 * robot, or once for the robots that share a {@link RobotClassLoader}, with its static fields exchanged; what crosses
 * the border between robot and simulator is shared by all.
 */
public final class LoadingRules {
    /** What the robot's loader does with a class. */
    public enum Treatment {
        /** The application's or the JDK's class, one for all robots. */
        SHARED,
        /** Defined per robot as it is: it is part of the machinery that rewritten code calls. */
        PER_ROBOT_PLAIN,
        /** Defined per robot after rewriting. */
        PER_ROBOT_REWRITTEN
    }

    private static final String HOOKS = "brickless.kernel.hooks.";
    private static final Set<String> JDK_PACKAGES = jdkPackages();
    private static final LoadingRules STANDARD = standardRules();

    private final List<Rule> rules;

    private LoadingRules(List<Rule> rules) {
        this.rules = List.copyOf(rules);
    }

    /** The rules for programs. */
    public static LoadingRules standard() {
        return STANDARD;
    }

    private static LoadingRules standardRules() {
        List<Rule> rules = new ArrayList<>();
        for (String shared : new String[] {"VirtualMachine", "Budget", "StaticState", "ProgramKilled", "IdentityHashed",
                "NamedMonitor", "OwnedLock", "InstructionCharges", "FloatingText",
            "ThrowableText", "JdkCall", "JdkCalls", "ProgramThreadGroup"}) {
            rules.add(new Rule(HOOKS + shared, false, Treatment.SHARED));
        }
        rules.add(new Rule(HOOKS, true, Treatment.PER_ROBOT_PLAIN));
        rules.add(new Rule("brickless.hardware.BrickAccess", false, Treatment.PER_ROBOT_PLAIN));
        rules.add(new Rule("brickless.junit.brick.", true, Treatment.PER_ROBOT_REWRITTEN));
        rules.add(new Rule("brickless.concurrent.", true, Treatment.PER_ROBOT_REWRITTEN));
        for (String shared : new String[] {"brickless.", "org.slf4j.", "org.junit.", "junit.", "org.opentest4j.",
                "org.assertj.", "org.hamcrest.",
            "org.apiguardian."}) {
            rules.add(new Rule(shared, true, Treatment.SHARED));
        }
        return new LoadingRules(rules);
    }

    private static Set<String> jdkPackages() {
        Set<String> packages = new HashSet<>();
        ModuleFinder.ofSystem().findAll().forEach(module -> packages.addAll(module.descriptor().packages()));
        return packages;
    }

    /** These rules, but classes whose names begin with {@code prefix} (a package and a dot) are rewritten. */
    public LoadingRules rewriting(String prefix) {
        List<Rule> extended = new ArrayList<>();
        extended.add(new Rule(prefix, true, Treatment.PER_ROBOT_REWRITTEN));
        extended.addAll(rules);
        return new LoadingRules(extended);
    }

    /** The treatment of a class, by its binary name such as {@code lejos.hardware.port.Port$Kind}. */
    public Treatment of(String binaryName) {
        for (Rule rule : rules) {
            if (rule.fits(binaryName)) {
                return rule.treatment;
            }
        }
        int packageEnd = binaryName.lastIndexOf('.');
        boolean jdk = packageEnd > 0 && (binaryName.startsWith("java.")
                || JDK_PACKAGES.contains(binaryName.substring(0, packageEnd)));
        return jdk ? Treatment.SHARED : Treatment.PER_ROBOT_REWRITTEN;
    }

    /**
     * Whether a class that is defined per robot comes from the application even if the program's class path has one of
     * that name too.
     */
    boolean isOurs(String binaryName) {
        return binaryName.startsWith("lejos.") || binaryName.startsWith("brickless.");
    }

    /** A package (with its subpackages) or one class (with its nested ones). */
    private record Rule(String name, boolean prefix, Treatment treatment) {
        boolean fits(String binaryName) {
            return prefix ? binaryName.startsWith(name) : binaryName.equals(name) || binaryName.startsWith(name + "$");
        }
    }
}
