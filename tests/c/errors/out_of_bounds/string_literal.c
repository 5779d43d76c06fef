/* Behind a string literal. */
int main(void)
{
    const char *s = "scout";
    volatile int i = 6;

    return s[i]; // error: out of bounds
}
