/* An array of negative size. */
static int list[3 - 4]; // error: negative

int main(void)
{
    return 0;
}
