package brickless.concurrent;

import java.util.Iterator;
import java.util.List;
import java.util.function.Consumer;

/** Walks over a copy of a collection and removes from the original. */
final class CopyIterator<E> implements Iterator<E> {
    private final Iterator<E> copy;
    private final Consumer<E> remover;
    private E last;
    private boolean removable;

    CopyIterator(List<E> copy, Consumer<E> remover) {
        this.copy = copy.iterator();
        this.remover = remover;
    }

    @Override
    public boolean hasNext() {
        return copy.hasNext();
    }

    @Override
    public E next() {
        last = copy.next();
        removable = true;
        return last;
    }

    @Override
    public void remove() {
        if (!removable) {
            throw new IllegalStateException();
        }
        removable = false;
        remover.accept(last);
    }
}
