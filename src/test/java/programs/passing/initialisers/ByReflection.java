package programs.passing.initialisers;

import java.util.function.Supplier;

/**
 * Reflection and method references initialise classes like direct uses.
 *
 * @expected exited 0
 * @prints forName
 * @prints newInstance
 * @prints made
 * @prints method
 * @prints field
 * @prints reference made
 * @prints referenced
 */
public class ByReflection {
    static class Named {
        static {
            say("forName");
        }
    }

    static class Created {
        static {
            say("newInstance");
        }

        Created() {
            say("made");
        }
    }

    static class Invoked {
        static {
            say("method");
        }

        static void invoke() {
        }
    }

    static class Read {
        static int value = say("field");
    }

    static class Referenced {
        static {
            say("reference made");
        }
    }

    static int say(String text) {
        System.out.println(text);
        return 0;
    }

    public static void main(String[] args) throws Exception {
        Class.forName(ByReflection.class.getName() + "$Named");
        Created.class.getDeclaredConstructor().newInstance();
        Invoked.class.getDeclaredMethod("invoke").invoke(null);
        Read.class.getDeclaredField("value").get(null);
        Supplier<Referenced> factory = Referenced::new;
        factory.get();
        say("referenced");
    }
}
