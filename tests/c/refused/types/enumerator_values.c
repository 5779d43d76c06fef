/* Enumerators are constant ints, each defined once. */
static int n = 3;
enum a { A = n }; // error: value of 'A' is not an integer constant expression
enum b { B = 1.5 }; // error: value of 'B' is not an integer constant expression
enum c { C, D, C }; // error: C

int main(void)
{
    return D;
}
