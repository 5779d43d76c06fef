/* Assignment to something that is no object. */
int main(void)
{
    int a = 1, b = 2;

    a + b = 3; // error: assign
    return a;
}
