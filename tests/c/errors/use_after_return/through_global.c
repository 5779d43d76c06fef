/* A global pointer outlives what it points to. */
static struct point { int x, y; } *last;

static void go(int x)
{
    struct point here = { x, 2 };

    last = &here;
}

int main(void)
{
    go(1);
    last->y = 3; // error: use after return
    return 0;
}
