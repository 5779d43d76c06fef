/* The value of a switch is an integer, each case a constant of its own. */
int main(void)
{
    double d = 1;
    int n = 2, *p = &n;

    switch (d) { // error: statement requires expression of integer type ('double' invalid)
    case 1: return 1;
    }
    switch (p) { // error: statement requires expression of integer type ('int *' invalid)
    default: return 1;
    }
    switch (n) {
    case 1.5: return 1; // error: case label is not an integer constant expression
    case 4: return 2;
    case 2 + 2: return 3; // error: 4
    }
    return 0;
}
