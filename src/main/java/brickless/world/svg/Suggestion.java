package brickless.world.svg;

import java.util.Locale;

/** Finds what a mistyped word may have meant. */
final class Suggestion {
    private Suggestion() {}

    /** {@code "; did you mean x?"} for the nearest word within two edits, else an empty text. */
    static String nearest(String word, Iterable<String> allowed) {
        String lower = word.strip().toLowerCase(Locale.ROOT);
        if (lower.length() > 40) {
            return "";
        }
        String best = null;
        int bestDistance = Math.min(3, Math.max(2, lower.length() / 2 + 1));
        for (String candidate : allowed) {
            int distance = distance(lower, candidate.toLowerCase(Locale.ROOT));
            if (distance < bestDistance || distance == bestDistance && best != null && candidate.compareTo(best) < 0) {
                best = candidate;
                bestDistance = distance;
            }
        }
        return best == null ? "" : "; did you mean " + best + "?";
    }

    /** Edits (insert, delete, replace) between two words. */
    private static int distance(String a, String b) {
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[b.length()];
    }
}
