package brickless.files;

import java.util.ArrayList;
import java.util.List;

/** Names of files as text: separated by slashes, absolute ones begin with one. */
final class Names {
    private Names() {}

    /** The words between slashes. */
    static List<String> split(String path) {
        List<String> names = new ArrayList<>();
        for (String name : path.split("/")) {
            if (!name.isEmpty()) {
                names.add(name);
            }
        }
        return names;
    }

    /** The names on the way from the root to a file, without {@code .} and {@code ..}. */
    static List<String> fromRoot(String path) {
        List<String> names = new ArrayList<>();
        for (String name : split(absolute(path))) {
            if (name.equals("..")) {
                if (!names.isEmpty()) {
                    names.remove(names.size() - 1);
                }
            } else if (!name.equals(".")) {
                names.add(name);
            }
        }
        return names;
    }

    /** The path, behind the working folder if it is relative. */
    static String absolute(String path) {
        if (path.startsWith("/")) {
            return path;
        }
        return path.isEmpty() ? BrickFiles.WORKING_FOLDER : BrickFiles.WORKING_FOLDER + "/" + path;
    }

    /** The one absolute path without {@code .} and {@code ..} for a file. */
    static String canonical(String path) {
        return "/" + String.join("/", fromRoot(path));
    }
}
