package programs.passing.initialisers;

/**
 * Classes are initialised at first use: superclass first, before the arguments of a constructor, not by constants or
 * arrays.
 *
 * @expected exited 0
 * @prints main
 * @prints constant 7
 * @prints array 0
 * @prints parent
 * @prints child
 * @prints argument
 * @prints created
 * @prints enum ONE
 * @prints inherited static initialises the parent only: other parent
 */
public class Order {
    static class Parent {
        static {
            say("parent");
        }
    }

    static class Child extends Parent {
        static final int CONSTANT = 7;

        static {
            say("child");
        }

        Child(int argument) {
            say("created");
        }
    }

    static class OtherParent {
        static String name = other();

        static String other() {
            return "other parent";
        }
    }

    static class OtherChild extends OtherParent {
        static {
            say("never");
        }
    }

    enum Number {
        ONE;

        static {
            say("enum " + ONE);
        }
    }

    static void say(String text) {
        System.out.println(text);
    }

    static int argument() {
        say("argument");
        return 1;
    }

    public static void main(String[] args) {
        say("main");
        say("constant " + Child.CONSTANT);
        say("array " + new Child[0].length);
        new Child(argument());
        Number.ONE.name();
        say("inherited static initialises the parent only: " + OtherChild.name);
    }
}
