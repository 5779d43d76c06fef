/* A member that the struct does not have. */
struct point { int x, y; };

int main(void)
{
    struct point p = { 1, 2 };

    return p.z; // error: member
}
