package brickless.simulation;

import java.util.Arrays;
import java.util.regex.Pattern;

/** Side of a robot that the names of a program's variables tell. */
enum Side {
    LEFT("(?i:.*(left|links|gauche|izq|esquerd|sinistr).*|l|l_?motor)|.*[a-z0-9_]L"),
    RIGHT("(?i:.*(right|rechts|droit|derech|direit|destr).*|r|r_?motor)|.*[a-z0-9_]R"),
    REAR("(?i:.*(rear|back|behind|hinten|arriere|atras).*)"),
    UNKNOWN("");

    private final Pattern names;

    Side(String names) {
        this.names = Pattern.compile(names);
    }

    /** The side that one of the names, separated by spaces, tells. */
    static Side of(String names) {
        return Arrays.stream(names.split(" "))
                .flatMap(name -> Arrays.stream(values()).filter(side -> side.names.matcher(name).matches()))
                .filter(side -> side != UNKNOWN).findFirst().orElse(UNKNOWN);
    }
}
