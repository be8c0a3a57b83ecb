package brickless.junit;

import java.util.function.Predicate;

/** Expectations about one value of a run; see {@link Expect}. */
public final class ValueExpectation<T> {
    private final Course<T> course;

    ValueExpectation(Course<T> course) {
        this.course = course;
    }

    /** Lets time pass until the value satisfies the condition; fails if it does not in time. */
    public void eventually(String condition, Predicate<? super T> holds) {
        if (!course.until(holds)) {
            throw course.failure("eventually", condition);
        }
    }

    /** Lets the time pass; fails as soon as the value does not satisfy the condition. */
    public void always(String condition, Predicate<? super T> holds) {
        if (course.until(holds.negate())) {
            throw course.failure("always", condition);
        }
    }

    /** Lets the time pass; fails as soon as the value satisfies the condition. */
    public void never(String condition, Predicate<? super T> holds) {
        if (course.until(holds)) {
            throw course.failure("never", condition);
        }
    }
}
