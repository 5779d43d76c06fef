/* Two definitions of one struct. */
struct point { int x, y; };
struct point { int x, y, z; }; // error: redefinition

int main(void)
{
    return 0;
}
