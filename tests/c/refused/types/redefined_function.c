/* Two bodies for one function. */
static int f(void) { return 1; }
static int f(void) { return 2; } // error: redefinition

int main(void)
{
    return f();
}
