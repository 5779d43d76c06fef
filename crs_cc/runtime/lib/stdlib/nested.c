/* Pointers to nested functions (GNU C), see crs_cc/frontend/check/nested.py. */

void *__crs_take_thunk(unsigned *chains, void **thunks, int count, unsigned chain);
void __crs_release_thunks(unsigned *chains, int count, unsigned chain);

/* Returns the thunk that calls a nested function for a frame. Frames below this one are dead: they
 * were left by longjmp. */
void *__crs_take_thunk(unsigned *chains, void **thunks, int count, unsigned chain)
{
    int here[1], free = -1;

    for (int i = 0; i < count; i++) {
        if (chains[i] == chain)
            return thunks[i];
        if (free < 0 && chains[i] < (unsigned)here)
            free = i;
    }
    if (free < 0)
        __crs_stop("stack overflow");
    chains[free] = chain;
    return thunks[free];
}

void __crs_release_thunks(unsigned *chains, int count, unsigned chain)
{
    for (int i = 0; i < count; i++)
        if (chains[i] == chain)
            chains[i] = 0;
}
