/* A struct is copied from an array of chars that is too small for it. */
struct point { double x, y, z; };

int main(void)
{
    char bytes[16] = { 0 };
    struct point p;

    p = *(struct point *) bytes; // error: out of bounds
    return p.x > 0;
}
