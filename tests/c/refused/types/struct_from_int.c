/* A struct from an int. */
struct point { int x, y; };

int main(void)
{
    struct point p = 5; // error: initial
    return p.x;
}
