package brickless.loading;

import brickless.kernel.hooks.Budget;
import brickless.kernel.hooks.StaticState;
import brickless.kernel.hooks.VirtualMachine;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * One of the robots that run the classes of a {@link RobotClassLoader}: what is static in them, for this robot. Only
 * the robot that was {@linkplain #enter entered} last may run. Belongs to whoever runs the robots, one at a time.
 */
public final class RobotContext {
    private final RobotClassLoader loader;
    private final StaticExchange exchange;
    private final List<StaticState> states = new ArrayList<>();
    /** Those of {@link #states} that can still change. */
    private final List<StaticState> changing = new ArrayList<>();
    private StaticState hooks;

    /**
     * Creates a context.
     *
     * @param exchange of a loader that several robots share; null if there is no other
     */
    RobotContext(RobotClassLoader loader, StaticExchange exchange) {
        this.loader = loader;
        this.exchange = exchange;
    }

    /** The loader of the robot's classes; between calls of {@link #enter} its classes are this robot's. */
    public RobotClassLoader loader() {
        return loader;
    }

    /** Connects this robot's hooks to its kernel, see {@link RobotClassLoader#bind}. */
    public Budget bind(VirtualMachine kernel) {
        return during(() -> {
            Budget budget = loader.bind(kernel);
            hooks = (StaticState) budget;
            return budget;
        });
    }

    /** Makes this robot the one whose code may run. */
    public void enter() {
        if (exchange != null) {
            exchange.enter(this);
        }
    }

    /** Does something with the classes as this robot's, also while another robot runs. */
    public <T> T during(Supplier<T> action) {
        RobotContext before = exchange == null ? null : exchange.present();
        enter();
        try {
            return action.get();
        } finally {
            if (before != null) {
                before.enter();
            }
        }
    }

    /** Drops everything that the robot has left. It cannot run any more. */
    void drop() {
        states.clear();
        changing.clear();
        hooks = null;
    }

    void save(List<StaticClass> classes) {
        addMissing(classes);
        boolean someFinal = false;
        for (int i = 0; i < changing.size(); i++) {
            StaticState state = changing.get(i);
            state.save();
            someFinal |= state.isFinal();
        }
        if (someFinal) {
            changing.removeIf(StaticState::isFinal);
        }
        if (hooks != null) {
            hooks.save();
        }
    }

    void load(List<StaticClass> classes) {
        addMissing(classes);
        for (int i = 0; i < states.size(); i++) {
            states.get(i).load();
        }
        if (hooks != null) {
            hooks.load();
        }
    }

    private void addMissing(List<StaticClass> classes) {
        while (states.size() < classes.size()) {
            StaticState state = classes.get(states.size()).fresh();
            states.add(state);
            changing.add(state);
        }
    }
}
