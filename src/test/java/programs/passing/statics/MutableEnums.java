package programs.passing.statics;

/**
 * Constants of enums are the robot's own, also by name.
 *
 * @expected exited 0
 * @prints LEFT 3 true true
 * @prints RIGHT 2 true true
 * @prints BOTH 5 true true
 * @prints No enum constant programs.passing.statics.MutableEnums.Motor.NONE
 * @prints Name is null
 * @prints SECONDS
 * @prints both
 */
public class MutableEnums {
    enum Motor {
        LEFT, RIGHT, BOTH {
            @Override
            void turn() {
                LEFT.turn();
                RIGHT.turn();
                super.turn();
            }
        };

        private static int turns;
        private int turned;

        void turn() {
            turned++;
            turns++;
        }

        int turned() {
            return this == BOTH ? turns : turned;
        }
    }

    static String name(Motor motor) {
        switch (motor) {
            case BOTH:
                return "both";
            default:
                return "one";
        }
    }

    static void pause() {
        try {
            Thread.sleep((long) (Math.random() * 10));
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    public static void main(String[] args) {
        pause();
        Motor.LEFT.turn();
        pause();
        Motor.BOTH.turn();
        pause();
        Motor.valueOf("LEFT").turn();
        pause();
        Enum.valueOf(Motor.class, "RIGHT").turn();
        for (Motor motor : Motor.values()) {
            System.out.println(motor + " " + Math.min(motor.turned(), 5) + " "
                    + (motor == Motor.valueOf(motor.name())) + " " + (motor == Motor.values()[motor.ordinal()]));
        }
        try {
            Motor.valueOf("NONE");
        } catch (IllegalArgumentException e) {
            System.out.println(e.getMessage());
        }
        try {
            Motor.valueOf(null);
        } catch (NullPointerException e) {
            System.out.println(e.getMessage());
        }
        System.out.println(java.util.concurrent.TimeUnit.valueOf("SECONDS"));
        System.out.println(name(Motor.BOTH));
    }
}
