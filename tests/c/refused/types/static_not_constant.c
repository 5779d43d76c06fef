/* A static object whose initialiser is not constant. */
static int f(void) { return 1; }
static int level = f(); // error: constant

int main(void)
{
    return level;
}
