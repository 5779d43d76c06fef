/* A struct as a condition. */
struct point { int x, y; };

int main(void)
{
    struct point p = { 1, 2 };

    if (p) // error: scalar
        return 1;
    return 0;
}
