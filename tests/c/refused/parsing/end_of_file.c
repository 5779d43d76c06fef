/* A file that ends in the middle. */
int main(void)
{
    if (1) {
        return 0;
}  // error: unexpected end of file
