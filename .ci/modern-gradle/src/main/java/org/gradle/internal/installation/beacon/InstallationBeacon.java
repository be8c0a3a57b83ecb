package org.gradle.internal.installation.beacon;

/** Gradle finds its own directory by the jar in which this class is. */
public class InstallationBeacon {
}
