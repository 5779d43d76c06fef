/* The value is missing in a copy of a copy too. */
struct pose { int x, y, heading; };

int main(void)
{
    struct pose a, b, c;

    a.x = a.y = 1;
    b = a;
    c = b;
    return c.heading; // error: uninitialised read
}
