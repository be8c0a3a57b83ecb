package programs.passing.concurrency;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Completable futures: chains, combinations, failures, time-outs.
 *
 * @expected exited 0
 * @prints chain 42
 * @prints combined 3
 * @prints recovered bad
 * @prints wrapped java.lang.IllegalStateException
 * @prints all true
 * @prints any first
 * @prints timed out
 * @prints default -1
 */
public class FutureChain {
    /** The program. */
    public static void main(String[] args) throws Exception {
        CompletableFuture<Integer> chain = CompletableFuture.supplyAsync(() -> 20).thenApply(x -> x + 1)
                .thenApplyAsync(x -> x * 2);
        System.out.println("chain " + chain.get());
        CompletableFuture<Integer> one = CompletableFuture.supplyAsync(() -> 1);
        CompletableFuture<Integer> two = CompletableFuture.supplyAsync(() -> 2);
        System.out.println("combined " + one.thenCombine(two, Integer::sum).join());
        CompletableFuture<String> bad = CompletableFuture.supplyAsync(() -> {
            throw new IllegalStateException("bad");
        });
        System.out.println("recovered " + bad.exceptionally(e -> e.getCause().getMessage()).join());
        try {
            bad.join();
        } catch (CompletionException e) {
            System.out.println("wrapped " + e.getCause().getClass().getName());
        }
        CompletableFuture<Void> all = CompletableFuture.allOf(one, two, chain);
        all.get(5, TimeUnit.SECONDS);
        System.out.println("all " + all.isDone());
        CompletableFuture<String> slow = new CompletableFuture<>();
        System.out.println("any " + CompletableFuture.anyOf(slow, CompletableFuture.completedFuture("first")).join());
        try {
            slow.orTimeout(20, TimeUnit.MILLISECONDS).get();
        } catch (ExecutionException e) {
            System.out.println(e.getCause() instanceof TimeoutException ? "timed out" : "other failure");
        }
        System.out.println("default " + new CompletableFuture<Integer>()
                .completeOnTimeout(-1, 20, TimeUnit.MILLISECONDS).join());
    }
}
