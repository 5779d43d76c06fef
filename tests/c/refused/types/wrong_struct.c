/* One struct assigned to another. */
struct point { int x, y; };
struct size { int x, y; };

int main(void)
{
    struct point p = { 1, 2 };
    struct size s;

    s = p; // error: point
    return s.x;
}
