package brickless.bench;

import brickless.trace.JsonText;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Results of many cases, for people and as JSON. */
final class Table {
    /**
     * One result.
     *
     * @param jdk feature version
     */
    record Row(BenchCase bench, int jdk, Figures figures) {}

    private static final int NAME_WIDTH = 18;

    private final List<Row> rows = new ArrayList<>();

    /** Adds a result; if its yardstick was measured before on the same JDK, the ratio to it becomes one more figure. */
    Row add(BenchCase bench, int jdk, Figures figures) {
        bench.yardstick().flatMap(name -> rows.stream()
                .filter(row -> row.jdk() == jdk && row.bench().name().equals(name)).findFirst())
                .ifPresent(bare -> figures.put("timesBare",
                        figures.get("nanosPerStep") / bare.figures().get("nanosPerStep")));
        Row row = new Row(bench, jdk, figures);
        rows.add(row);
        return row;
    }

    /** The table: groups in the order of the cases, a heading each. */
    String text() {
        StringBuilder text = new StringBuilder();
        for (String group : BenchCase.ALL.stream().map(BenchCase::group).distinct().toList()) {
            List<Row> members = rows.stream().filter(row -> row.bench().group().equals(group)).toList();
            if (!members.isEmpty()) {
                group(text, members);
            }
        }
        return text.toString();
    }

    private static void group(StringBuilder text, List<Row> members) {
        List<String> names = members.stream().flatMap(row -> row.figures().values().keySet().stream())
                .distinct().toList();
        text.append(padded("case")).append("  JDK");
        names.forEach(name -> text.append("  ").append(name));
        text.append('\n');
        for (BenchCase bench : BenchCase.ALL) {
            members.stream().filter(row -> row.bench() == bench).forEach(row -> line(text, row, names));
        }
        text.append('\n');
    }

    private static void line(StringBuilder text, Row row, List<String> names) {
        text.append(padded(row.bench().name())).append(String.format(Locale.ROOT, "  %3d", row.jdk()));
        for (String name : names) {
            Double value = row.figures().values().get(name);
            text.append("  ").append(String.format("%" + name.length() + "s", value == null ? "" : number(value)));
        }
        text.append('\n');
    }

    private static String number(double value) {
        String format = Math.abs(value) >= 100 ? "%.0f" : Math.abs(value) >= 10 ? "%.1f" : "%.2f";
        return String.format(Locale.ROOT, format, value);
    }

    private static String padded(String name) {
        return String.format("%-" + NAME_WIDTH + "s", name);
    }

    /** One JSON object: the host and an object for every result. */
    String json(String effort) {
        return JsonText.object(line -> {
            line.text("effort", effort).text("os", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
            line.integer("processors", Runtime.getRuntime().availableProcessors());
            line.objects("results", rows, (row, fields) -> {
                fields.text("case", row.bench().name()).integer("jdk", row.jdk())
                        .text("conditions", row.bench().conditions().name().toLowerCase(Locale.ROOT));
                fields.raw("figures", row.figures().json());
            });
        });
    }
}
