/* Two parameters of one name. */
static int f(int a, int a) { return a; } // error: redefinition

int main(void)
{
    return f(1, 2);
}
