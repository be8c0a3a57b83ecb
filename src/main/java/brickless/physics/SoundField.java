package brickless.physics;

import java.util.ArrayList;
import java.util.List;

/** The sound in an arena: how loud it is, and who sends ultrasound. Guarded by the arena's monitor. */
public final class SoundField {
    /** Background noise, decibels: assumption, a quiet room. */
    public static final double QUIET_DECIBELS = 40;

    private final List<Source> sources = new ArrayList<>();
    private double decibels = QUIET_DECIBELS;

    /** Something that sends ultrasound. */
    public interface Source {
        /** Whether its sound arrives at a place. */
        boolean reaches(Aim place);
    }

    /** Sets how loud it is everywhere; never less than the background noise. */
    public void setDecibels(double newDecibels) {
        decibels = Math.max(QUIET_DECIBELS, newDecibels);
    }

    /** How loud it is everywhere. */
    public double decibels() {
        return decibels;
    }

    /** A source begins to send. */
    public void add(Source source) {
        sources.add(source);
    }

    /** A source stops. */
    public void remove(Source source) {
        sources.remove(source);
    }

    /** Whether ultrasound of any source but one's own arrives at a place. */
    public boolean heard(Source own, Aim place) {
        for (int i = 0; i < sources.size(); i++) {
            if (sources.get(i) != own && sources.get(i).reaches(place)) {
                return true;
            }
        }
        return false;
    }
}
