/* A struct where an int is wanted. */
struct point { int x, y; };
static int twice(int n) { return 2 * n; }

int main(void)
{
    struct point p = { 1, 2 };

    return twice(p); // error: point
}
