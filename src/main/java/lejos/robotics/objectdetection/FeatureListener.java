package lejos.robotics.objectdetection;

/** Told what a detector finds. */
public interface FeatureListener {
    /** A detector found something. Called on the detector's thread, again and again as long as the object is there. */
    void featureDetected(Feature feature, FeatureDetector detector);
}
