/* An array without a size or an initialiser. */
int main(void)
{
    int list[]; // error: incomplete
    return 0;
}
