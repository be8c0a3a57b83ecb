package org.gradle.launcher;

import java.io.File;
import org.gradle.api.internal.file.FileCollectionFactory;
import org.gradle.cli.CommandLineArgumentException;
import org.gradle.cli.CommandLineParser;
import org.gradle.configuration.DefaultBuildClientMetaData;
import org.gradle.configuration.GradleLauncherMetaData;
import org.gradle.initialization.BuildRequestContext;
import org.gradle.initialization.DefaultBuildCancellationToken;
import org.gradle.initialization.DefaultBuildRequestContext;
import org.gradle.initialization.DefaultBuildRequestMetaData;
import org.gradle.initialization.NoOpBuildEventConsumer;
import org.gradle.initialization.layout.BuildLayoutFactory;
import org.gradle.internal.buildprocess.BuildProcessState;
import org.gradle.internal.classpath.ClassPath;
import org.gradle.internal.instrumentation.agent.AgentStatus;
import org.gradle.internal.logging.LoggingManagerInternal;
import org.gradle.internal.logging.services.DefaultLoggingManagerFactory;
import org.gradle.internal.logging.services.LoggingServiceRegistry;
import org.gradle.internal.nativeintegration.services.NativeServices;
import org.gradle.internal.nativeintegration.services.NativeServices.NativeServicesMode;
import org.gradle.internal.service.ServiceRegistry;
import org.gradle.launcher.cli.BuildEnvironmentConfigurationConverter;
import org.gradle.launcher.cli.Parameters;
import org.gradle.launcher.exec.BuildActionParameters;
import org.gradle.launcher.exec.BuildExecutor;
import org.gradle.launcher.exec.DefaultBuildActionParameters;
import org.gradle.tooling.internal.provider.action.ExecuteBuildAction;

/** The command line: runs one build in this process, as `gradle --no-daemon` does, and ends with status 0, or 1 when it failed. */
public class Main {
    /** Called by Gradle's own bootstrap, which has made the class loaders. */
    public void run(String[] arguments) {
        ServiceRegistry logging = LoggingServiceRegistry.newCommandLineProcessLogging();
        NativeServices.initializeOnDaemon(userHome(), NativeServicesMode.ENABLED);
        boolean failed;
        try (BuildProcessState process =
                new BuildProcessState(false, AgentStatus.disabled(), ClassPath.EMPTY, logging, NativeServices.getInstance())) {
            Parameters parameters = parameters(process.getServices(), arguments);
            LoggingManagerInternal console = logging.get(DefaultLoggingManagerFactory.class).create();
            console.setLevelInternal(parameters.getStartParameter().getLogLevel());
            console.attachProcessConsole(parameters.getStartParameter().getConsoleOutput());
            console.start();
            failed = process.getServices().get(BuildExecutor.class)
                    .execute(new ExecuteBuildAction(parameters.getStartParameter()), action(parameters), context()).hasFailure();
            console.stop();
        } catch (CommandLineArgumentException e) {
            System.err.println(e.getMessage());
            failed = true;
        }
        System.exit(failed ? 1 : 0);
    }

    private static File userHome() {
        String given = System.getenv("GRADLE_USER_HOME");
        return given != null ? new File(given) : new File(System.getProperty("user.home"), ".gradle");
    }

    private static Parameters parameters(ServiceRegistry services, String[] arguments) {
        CommandLineParser parser = new CommandLineParser();
        BuildEnvironmentConfigurationConverter converter =
                new BuildEnvironmentConfigurationConverter(new BuildLayoutFactory(), services.get(FileCollectionFactory.class));
        converter.configure(parser);
        Parameters parameters = converter.convertParameters(parser.parse(arguments), null);
        parameters.getProperties().getRequestedSystemProperties().forEach(System::setProperty);
        return parameters;
    }

    private static BuildActionParameters action(Parameters parameters) {
        return new DefaultBuildActionParameters(parameters.getDaemonParameters().getEffectiveSystemProperties(), System.getenv(),
                new File("").getAbsoluteFile(), parameters.getStartParameter().getLogLevel(), false, ClassPath.EMPTY);
    }

    private static BuildRequestContext context() {
        DefaultBuildRequestMetaData request = new DefaultBuildRequestMetaData(
                new DefaultBuildClientMetaData(new GradleLauncherMetaData()), System.currentTimeMillis(), false);
        return new DefaultBuildRequestContext(request, new DefaultBuildCancellationToken(), new NoOpBuildEventConsumer());
    }
}
