package brickless.concurrent.util;

import java.util.EmptyStackException;

/** {@code java.util.Stack} on virtual monitors. */
public class Stack<E> extends Vector<E> {
    private static final long serialVersionUID = 1L;

    /** Creates an empty stack. */
    public Stack() {
    }

    /** Puts an element on top and returns it. */
    public E push(E item) {
        addElement(item);
        return item;
    }

    /** Removes the top; EmptyStackException if there is none. */
    public synchronized E pop() {
        E top = peek();
        removeElementAt(size() - 1);
        return top;
    }

    /** The top; EmptyStackException if there is none. */
    public synchronized E peek() {
        if (isEmpty()) {
            throw new EmptyStackException();
        }
        return lastElement();
    }

    /** Whether there is no element. */
    public boolean empty() {
        return isEmpty();
    }

    /** Distance of an element from the top, which counts as 1; -1 if it is not there. */
    public synchronized int search(Object o) {
        int index = lastIndexOf(o);
        return index < 0 ? -1 : size() - index;
    }
}
