package brickless.world.svg;

/** A {@code viewBox}: the part of the plane that is shown. */
record ViewBox(double minX, double minY, double width, double height) {
    static ViewBox parse(String text) throws MalformedValueException {
        NumberScanner in = new NumberScanner(text);
        double[] n = new double[4];
        in.skipSeparator();
        for (int i = 0; i < 4; i++) {
            if (!in.numberAhead()) {
                throw new MalformedValueException("viewBox=\"" + LengthParser.shortened(text)
                        + "\" is not four numbers: minX minY width height in millimetres");
            }
            n[i] = in.number();
            in.skipSeparator();
        }
        if (!in.atEnd() || !(n[2] > 0) || !(n[3] > 0)) {
            throw new MalformedValueException("viewBox=\"" + LengthParser.shortened(text)
                    + "\" is not four numbers: minX minY width height, with width and height above 0");
        }
        return new ViewBox(n[0], n[1], n[2], n[3]);
    }

    /** How the box is laid into a rectangle, by {@code preserveAspectRatio}. */
    Affine fitInto(double x, double y, double w, double h, String preserveAspectRatio) throws MalformedValueException {
        String[] words = preserveAspectRatio.strip().split("\\s+");
        double sx = w / width;
        double sy = h / height;
        if (words[0].equals("none")) {
            return Affine.translate(x, y).then(Affine.scale(sx, sy)).then(Affine.translate(-minX, -minY));
        }
        if (!words[0].matches("x(Min|Mid|Max)Y(Min|Mid|Max)")) {
            throw new MalformedValueException("preserveAspectRatio=\"" + LengthParser.shortened(preserveAspectRatio)
                    + "\" is not known; allowed: none, xMidYMid meet, …");
        }
        boolean slice = words.length > 1 && words[1].equals("slice");
        double scale = slice ? Math.max(sx, sy) : Math.min(sx, sy);
        double dx = share(words[0].substring(1, 4)) * (w - width * scale);
        double dy = share(words[0].substring(5, 8)) * (h - height * scale);
        return Affine.translate(x + dx, y + dy).then(Affine.scale(scale, scale)).then(Affine.translate(-minX, -minY));
    }

    private static double share(String word) {
        return word.equals("Min") ? 0 : word.equals("Mid") ? 0.5 : 1;
    }
}
