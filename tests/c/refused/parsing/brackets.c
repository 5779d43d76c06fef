/* Brackets that are not closed, told with where they were opened. */
int f(int n)
{
    if (n {  // error: to close the '(' at
//        ^
        n++;
    }
    n = n * (n + 1;  // error: expected ')' before ';'
//                ^
    return n;
}
int g(void)
{
    for (;;) {
        if (f(1)) {
            break;
    }
}
int main(void)
{  // error: function definition is not allowed here
    return 0;
}
