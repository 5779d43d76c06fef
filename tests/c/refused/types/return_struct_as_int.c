/* A struct returned from a function that returns int. */
struct point { int x, y; };

static int f(struct point p)
{
    return p; // error: point
}

int main(void)
{
    return 0;
}
