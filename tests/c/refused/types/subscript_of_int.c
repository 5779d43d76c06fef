/* A subscript of something that is no array. */
int main(void)
{
    int n = 5;

    return n[2.5]; // error: subscript
}
